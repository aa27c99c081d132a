// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What searches for a robot's place say one after the other, added up until it is enough.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "mapping/place_choice.hpp"

namespace surefoot::mapping {

struct AgreementLimits {
  int searches = 3;           ///< that must say the same,
  int silent = 1;             ///< among them so many in a row that say nothing,
  double no_evidence = 0.5;   ///< a fit that says nothing; what places fit more in these searches
  double evidence = 0.5;      ///< adds up to so much,
  double way = 1.0;           ///< over so much way [m],
  double fit_standing = 0.6;  ///< or they fit so well in every one of them;
  double alike_way = 5.0;     ///< of way since places looked alike [m]: then other things are seen
};

class PlaceAgreement {
 public:
  explicit PlaceAgreement(const AgreementLimits& limits) : limits_(limits) {}

  /// A search that named this place, after so much way. Whether it is enough.
  [[nodiscard]] bool add(const Pose& T_map_world, double fit, double way,
                         const Eigen::Vector3d& robot_in_world, const ChoiceLimits& same);
  /// A search that named none.
  void add_silence();
  /// A search in which places looked alike: that one of them is not named any more says little.
  void add_alike(double way) { alike_at_ = way; }
  void forget() { agreed_.reset(); }

 private:
  struct Agreed {
    Pose T_map_world;
    double since = 0.0;  // way
    double fit = 1.0;    // the worst
    double evidence = 0.0;
    int searches = 0;
    int silent = 0;  // since the last of them
  };

  AgreementLimits limits_;
  std::optional<Agreed> agreed_;
  std::optional<double> alike_at_;  // way
};

}  // namespace surefoot::mapping
