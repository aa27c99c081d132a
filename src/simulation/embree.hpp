// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Embree 3 or 4, whichever CMake found: what our calls of it share, and the one that differs
// between them.
#pragma once

#if SUREFOOT_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace surefoot::simulation {

/// Embree on the caller's thread. By its own choice it takes the processor's widest vectors, and
/// ranges' last bits differ with the instructions: up to AVX2 it is the same for all x86-64 of the
/// last ten years.
inline RTCDevice new_device() {
#if defined(__x86_64__)
  return rtcNewDevice("threads=1,max_isa=avx2");
#else
  return rtcNewDevice("threads=1");
#endif
}

/// Casts 8 rays that point in similar directions; `valid` is -1 for those to cast, else 0.
inline void intersect_coherent8(const int* valid, RTCScene scene, RTCRayHit8& packet) {
#if SUREFOOT_EMBREE_MAJOR >= 4
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  rtcIntersect8(valid, scene, &packet, &arguments);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect8(valid, scene, &context, &packet);
#endif
}

}  // namespace surefoot::simulation
