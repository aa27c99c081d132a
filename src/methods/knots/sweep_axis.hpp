// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "core/preprocess.hpp"

namespace surefoot {

/// The axis about which a scan's beams turned as time went by, right-handed, LiDAR frame. Its
/// length is how steadily they did: 1 for a spinning sensor; about 0 where there are no times, or
/// where beams go to and fro.
[[nodiscard]] Eigen::Vector3f sweep_axis(const PreparedScan& scan);

/// Whether beams turn the one way in one scan and the other way in another. No sensor changes it:
/// one of the two is mirrored, or its times run backwards.
[[nodiscard]] bool are_opposite(const Eigen::Vector3f& axis, const Eigen::Vector3f& other);

}  // namespace surefoot
