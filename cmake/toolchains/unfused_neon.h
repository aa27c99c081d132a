// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Included before all else where the library for ARM is to give the same bits as on x86-64: Eigen's
// products and sums there are fused ones, by these intrinsics, which -ffp-contract=off leaves alone.
#pragma once

#include <arm_neon.h>

#define vfma_f32(sum, a, b) vadd_f32(sum, vmul_f32(a, b))
#define vfmaq_f32(sum, a, b) vaddq_f32(sum, vmulq_f32(a, b))
#define vfmaq_f64(sum, a, b) vaddq_f64(sum, vmulq_f64(a, b))
#define vfmaq_n_f32(sum, a, b) vaddq_f32(sum, vmulq_n_f32(a, b))
#define vfmaq_n_f64(sum, a, b) vaddq_f64(sum, vmulq_n_f64(a, b))
#define vfmaq_laneq_f32(sum, a, b, lane) vaddq_f32(sum, vmulq_laneq_f32(a, b, lane))
#define vfmaq_laneq_f64(sum, a, b, lane) vaddq_f64(sum, vmulq_laneq_f64(a, b, lane))
