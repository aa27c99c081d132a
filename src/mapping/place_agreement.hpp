// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What searches for a robot's place say one after the other, added up until it is enough.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "mapping/place_choice.hpp"

namespace surefoot::mapping {

struct AgreementLimits {
  int searches = 3;            ///< that must say the same,
  int silent = 1;              ///< among them so many in a row that say nothing,
  double no_evidence = 0.4;    ///< a fit that says nothing; what places fit more in these searches
  double evidence = 0.5;       ///< adds up to so much,
  double way = 1.0;            ///< over so much way [m],
  double fit_standing = 0.55;  ///< or in the mean they fit so well;
  double alike_way = 4.0;      ///< of way since places looked alike [m]: then other things are seen
  double missing = 0.15;       ///< walls: a pose at which they were missing is not believed
  double missing_way = 10.0;   ///< on so much way [m]: what showed it is out of sight by then
};

class PlaceAgreement {
 public:
  explicit PlaceAgreement(const AgreementLimits& limits) : limits_(limits) {}

  /// A search that named this place, after so much way. Whether it is enough.
  [[nodiscard]] bool add(const Pose& T_map_world, double fit, double way,
                         const Eigen::Vector3d& robot_in_world, const ChoiceLimits& same);
  /// A place that was asked and does not show what is seen, whether or not it fits later on.
  void add_missing(const Pose& T_map_world, double share, double way);
  /// A search that named none.
  void add_silence();
  /// A search in which places looked alike: that one of them is not named any more says little.
  void add_alike(double way) { alike_at_ = way; }
  void forget() { agreed_.reset(); }
  /// The robot's world is another one: poses in it that were remembered say nothing of it.
  void begin_anew() { *this = PlaceAgreement(limits_); }

 private:
  struct Agreed {
    Pose T_map_world;
    double since = 0.0;  // way
    double evidence = 0.0;
    int searches = 0;
    int silent = 0;  // since the last of them
  };

  struct Missing {
    Pose T_map_world;
    double at = 0.0;  // way
  };

  [[nodiscard]] bool walls_were_missing(const Pose& T_map_world, double way,
                                        const Eigen::Vector3d& robot_in_world,
                                        const ChoiceLimits& same) const;

  AgreementLimits limits_;
  std::vector<Missing> missing_;
  std::optional<Agreed> agreed_;
  std::optional<double> alike_at_;  // way
};

}  // namespace surefoot::mapping
