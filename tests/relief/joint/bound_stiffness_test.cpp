#include "relief/joint/bound_stiffness.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>

namespace relievo {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double radius = 100;
constexpr double pi = 3.14159265358979323846;

/// Marks all around a circle, whose part is 0.
std::vector<BoundMark> marks_around(int count) {
  std::vector<BoundMark> marks;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * pi * (i + 0.3) / count;
    marks.push_back(
        {0, {radius * std::cos(angle), radius * std::sin(angle)}, 2 * pi * radius / count});
  }
  return marks;
}

VectorXd wave(const std::vector<BoundMark>& marks, int number) {
  VectorXd values(static_cast<Index>(marks.size()));
  for (Index i = 0; i < values.size(); ++i) {
    const Point2 p = marks[static_cast<size_t>(i)].position;
    values[i] = std::cos(number * std::atan2(p.y, p.x));
  }
  return values;
}

/// A disc that is glued along its whole rim: waves cos(k angle) meet the resistance k.
BoundStiffness disc_stiffness(int count) {
  BoundStiffness known{marks_around(count), MatrixXd::Zero(count, count)};
  for (int k = 1; k < count / 2; ++k) {
    for (const double phase : {0.0, pi / 2}) {
      VectorXd mode(count);
      for (int i = 0; i < count; ++i) mode[i] = std::cos(2 * pi * k * i / count + phase);
      known.K += 4 * pi * k / (count * count) * mode * mode.transpose();
    }
  }
  return known;
}

BoundStiffness random_stiffness(std::mt19937& random) {
  std::uniform_real_distribution<double> anywhere(0, 1);
  BoundStiffness known;
  for (int i = 0; i < 30; ++i)
    known.marks.push_back({i % 3, {anywhere(random), anywhere(random)}, anywhere(random)});
  const MatrixXd root = MatrixXd::NullaryExpr(30, 30, [&] { return anywhere(random); });
  known.K = root * root.transpose();
  return known;
}

TEST(KnownWaves, AreAllThereIsOnTheSameMarks) {
  std::mt19937 random(1);
  const BoundStiffness known = random_stiffness(random);
  const MatrixXd K = with_known_waves(known, known.marks, MatrixXd::Identity(30, 30));
  EXPECT_LT((K - known.K).norm(), 1e-12 * known.K.norm());
}

TEST(KnownWaves, LeaveTheStiffnessSymmetricAndNeverNegative) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> anywhere(0, 1);
  const BoundStiffness known = random_stiffness(random);
  std::vector<BoundMark> marks;
  for (int i = 0; i < 80; ++i)  // part 3 is not known
    marks.push_back({i % 4, {anywhere(random), anywhere(random)}, anywhere(random)});
  marks.push_back(marks.front());
  const MatrixXd K = with_known_waves(known, marks, MatrixXd::Identity(81, 81));
  EXPECT_EQ(K, K.transpose());
  const VectorXd values = Eigen::SelfAdjointEigenSolver<MatrixXd>(K).eigenvalues();
  EXPECT_GE(values.minCoeff(), -1e-12 * values.maxCoeff());
}

TEST(KnownWaves, KeepTheResistanceAgainstAnEvenRise) {
  BoundStiffness known = disc_stiffness(20);
  known.K += MatrixXd::Constant(20, 20, 0.4);
  const VectorXd even = VectorXd::Ones(53);
  const MatrixXd K = with_known_waves(known, marks_around(53), MatrixXd::Identity(53, 53));
  EXPECT_NEAR(even.dot(K * even), 0.4 * 20 * 20, 1e-9);
}

/// Far from B nothing moves in `near`: a ring whose inner rim is held at 0.9 of its radius.
MatrixXd ring_stiffness(int count) {
  MatrixXd K = MatrixXd::Zero(count, count);
  for (int k = 0; k < count / 2; ++k) {
    const double resistance = k == 0 ? -1 / std::log(0.9) : k / std::tanh(-k * std::log(0.9));
    for (const double phase : {0.0, pi / 2}) {
      VectorXd mode(count);
      for (int i = 0; i < count; ++i) mode[i] = std::cos(2 * pi * k * i / count + phase);
      K += (k == 0 ? 2 : 4) * pi * resistance / (count * count) * mode * mode.transpose();
    }
  }
  return K;
}

TEST(KnownWaves, GiveAllWavesOnAFinerMeshTheirResistance) {
  const BoundStiffness known = disc_stiffness(40);
  for (const int count : {64, 113, 200}) {
    const std::vector<BoundMark> marks = marks_around(count);
    const MatrixXd near = ring_stiffness(count);
    const MatrixXd K = with_known_waves(known, marks, near);
    for (const int number : {1, 2, 5, 12, count / 3}) {
      const VectorXd f = wave(marks, number);
      EXPECT_NEAR(f.dot(K * f) / (pi * number), 1, 0.5) << count << ' ' << number;
    }
    const VectorXd longest = wave(marks, 1);
    EXPECT_GT(longest.dot(near * longest), 9 * pi);
  }
}

TEST(KnownWaves, ReturnFromAFinerMesh) {
  const BoundStiffness known = disc_stiffness(160);
  const std::vector<BoundMark> marks = marks_around(40);
  const MatrixXd K = with_known_waves(known, marks, ring_stiffness(40));
  for (const int number : {1, 2, 3, 5}) {
    const VectorXd f = wave(marks, number);
    EXPECT_NEAR(f.dot(K * f) / (pi * number), 1, 0.3) << number;
  }
}

}  // namespace
}  // namespace relievo
