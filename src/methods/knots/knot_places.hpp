// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Where else in its map a scan may have been taken. docs/method.md, "Lost", "Is it right?".
#pragma once

#include <optional>

#include "methods/knots/knot_search.hpp"
#include "methods/knots/knot_track.hpp"

namespace surefoot {

/// How much better a scan fits at another place than where it was registered: of places so near
/// that somebody may have come there since the last scan.
[[nodiscard]] double rival_beside(const KnotTrack& track, const ScanPart& thinned,
                                  const RegisteredScan& registered);
/// Likewise, of all places that it is ever looked for.
[[nodiscard]] double rival_anywhere(const KnotTrack& track, const ScanPart& thinned,
                                    const RegisteredScan& registered);

/// A scan at the place of a region that fits best, if there is one that fits clearly best. Its
/// evidence tells of its rival by how far that stays behind: below zero.
/// @param left whether it went on in another map since, and may be anywhere
[[nodiscard]] std::optional<RegisteredScan> find_place(KnotTrack& track, const ScanPart& thinned,
                                                       const SearchRegion& region, bool left);

/// Whether a scan fits elsewhere as well as where it was found. Who is found elsewhere than where
/// it would be by itself was carried, nobody knows how far: of places that look alike, none is his.
/// Where it would be by itself only a place that fits clearly better speaks against it.
[[nodiscard]] bool has_twin(const KnotTrack& track, const ScanPart& thinned,
                            const RegisteredScan& found, bool left);

}  // namespace surefoot
