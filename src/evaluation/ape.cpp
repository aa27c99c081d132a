// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation/ape.hpp"

namespace surefoot::evaluation {

std::vector<double> absolute_errors(const AssociatedTrajectories& pairs, Relation relation) {
  std::vector<double> errors;
  errors.reserve(pairs.estimate.size());
  for (std::size_t i = 0; i < pairs.estimate.size(); ++i) {
    const Pose error = pairs.estimate[i].pose.inverse() * pairs.reference[i].pose;
    errors.push_back(size_of(error, relation));
  }
  return errors;
}

std::vector<SplitError> absolute_split_errors(const AssociatedTrajectories& pairs) {
  std::vector<SplitError> errors;
  errors.reserve(pairs.estimate.size());
  for (std::size_t i = 0; i < pairs.estimate.size(); ++i) {
    errors.push_back(split_error(pairs.reference[i].pose, pairs.estimate[i].pose));
  }
  return errors;
}

}  // namespace surefoot::evaluation
