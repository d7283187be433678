// Pseudo-inverse of a symmetric positive semidefinite matrix J in scaled variables: with D = diag(scale) and the
// eigen-decomposition D J D = V Λ Vᵀ,  J⁺ = D V Λ⁺ Vᵀ D,  where Λ⁺ drops eigenvalues ≤ threshold × the largest.
// A dropped mode is not moved; a zero in `scale` takes its row and column out.
#pragma once

#include <Eigen/Eigenvalues>

namespace mortise {

template <int N>
class PseudoInverse {
 public:
  using Vector = Eigen::Matrix<double, N, 1>;
  using Matrix = Eigen::Matrix<double, N, N>;

  PseudoInverse(const Matrix& symmetric, const Vector& scale, double threshold = 1e-10) {
    const Matrix scaled = scale.asDiagonal() * symmetric * scale.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Matrix> eigen(scaled);
    const double smallest = threshold * eigen.eigenvalues()[N - 1];
    for (int k = 0; k < N; ++k) kept_[k] = eigen.eigenvalues()[k] > smallest && eigen.eigenvalues()[k] > 0;
    for (int k = 0; k < N; ++k) inverse_[k] = kept_[k] > 0 ? 1 / eigen.eigenvalues()[k] : 0;
    basis_ = scale.asDiagonal() * eigen.eigenvectors();
  }

  /// J⁺ r.
  Vector operator*(const Vector& r) const { return basis_ * inverse_.cwiseProduct(basis_.transpose() * r); }
  /// J⁺.
  Matrix matrix() const { return basis_ * inverse_.asDiagonal() * basis_.transpose(); }
  /// |D r| without the dropped modes.
  double norm(const Vector& r) const { return kept_.cwiseProduct(basis_.transpose() * r).norm(); }

 private:
  Vector kept_, inverse_;  // 1 or 0; 1/λ or 0
  Matrix basis_;           // D V
};

}  // namespace mortise
