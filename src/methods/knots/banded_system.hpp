// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "surefoot/pose.hpp"

namespace surefoot {

/// Normal equations H delta = -g of a chain of poses, in which a pose shares terms with the next
/// two only: 6 x 6 blocks, two of them below the diagonal. Solved as such, in time linear in the
/// chain's length.
class BandedSystem {
 public:
  explicit BandedSystem(std::size_t poses);

  /// Adds to H's block (row, column), column <= row <= column + 2. Its transpose is implied.
  void add(std::size_t row, std::size_t column, const Matrix6& block) {
    blocks_[column][row - column] += block;
  }
  void add(std::size_t row, const Twist& gradient) { gradient_[row] += gradient; }
  /// Adds another chain of as many poses, times a factor; neither factorised.
  void add(const BandedSystem& other, double factor);
  /// Adds a shorter chain to the poses from `first` on.
  void add_at(std::size_t first, const BandedSystem& other);

  /// Cholesky factor, block by block; false if H is not positive definite or not finite.
  [[nodiscard]] bool factorise();
  /// delta, after factorise().
  [[nodiscard]] std::vector<Twist> solve() const;

  /// Blocks of H^-1 within the band: covariances of each pose and of it with the next two.
  class Covariance {
   public:
    /// Block (row, column), |row - column| <= 2.
    [[nodiscard]] Matrix6 operator()(std::size_t row, std::size_t column) const {
      const std::size_t upper = std::min(row, column);
      const Matrix6& block = blocks_[upper][std::max(row, column) - upper];
      return row < column ? Matrix6(block.transpose()) : block;
    }

    /// Of a pose the share `place.second` of the way from pose `place.first` to the next.
    [[nodiscard]] Matrix6 at(const std::pair<std::size_t, double>& place) const;
    /// Of `count` poses from `first` on.
    [[nodiscard]] Covariance part(std::size_t first, std::size_t count) const;

   private:
    friend class BandedSystem;
    std::vector<std::array<Matrix6, 3>> blocks_;
  };
  /// After factorise(): information of the last two poses, all others integrated out.
  [[nodiscard]] Eigen::Matrix<double, 12, 12> last_two_information() const;
  /// After factorise(), by Takahashi's recursion from the last pose to the first.
  [[nodiscard]] Covariance covariance() const;

 private:
  std::vector<std::array<Matrix6, 3>> blocks_;  // per column: diagonal, next, next but one; then L
  std::vector<Twist> gradient_;
};

}  // namespace surefoot
