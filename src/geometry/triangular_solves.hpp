// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Triangular systems of six by six with several right-hand sides, and what is made of them. Eigen
// goes through them in blocks whose size is the machine's, which the last bits follow; these are of
// four on any, as Eigen's are on x86-64.
#pragma once

#include <Eigen/Cholesky>

#include "surefoot/pose.hpp"

namespace surefoot {

enum class Diagonal { given, ones };

/// X of L X = B, in place. Of L the lower triangle is read, of Diagonal::ones what is below it.
void solve_lower(const Matrix6& L, Diagonal diagonal, Matrix6& X);
/// X of L^T X = B, likewise.
void solve_upper(const Matrix6& L, Diagonal diagonal, Matrix6& X);
/// X of X L^T = B, likewise.
void solve_from_right(const Matrix6& L, Matrix6& X);

/// H^-1 B of a decomposed H.
[[nodiscard]] Matrix6 solve(const Eigen::LDLT<Matrix6>& H, const Matrix6& B);
/// H^-1 of a decomposed H.
[[nodiscard]] Matrix6 inverse(const Eigen::LLT<Matrix6>& H);

}  // namespace surefoot
