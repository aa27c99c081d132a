// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What speaks against two submaps being one place where most of one lies on the other: streets
// whose houses are built alike fit by chance.
#pragma once

#include "mapping/outlook.hpp"
#include "mapping/submap_registration.hpp"

namespace surefoot::mapping {

/// Share of what stands and is flat that is not seen in an outlook, of what would be; or half of
/// that share of what is far away, if that is more: what moves is small and shows near by. 0 where
/// too little would be seen to tell.
[[nodiscard]] double missing_in(const Outlook& outlook, const RegistrationSubmap& seen,
                                const Pose& T_outlook_seen);

/// Share of what stands and is flat that lies beside a wall of the other one which runs the same
/// way, and on none, of what lies on one or beside one.
[[nodiscard]] double beside_walls(const RegistrationSubmap& other, const RegistrationSubmap& seen,
                                  const Pose& T_other_seen);

}  // namespace surefoot::mapping
