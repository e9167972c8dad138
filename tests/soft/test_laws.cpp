// Every law against its own derivatives, Hooke's law at rest and closed forms.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>
#include <string>

#include "common/error.h"
#include "server/physics/mechanics/soft/laws/constitutive_law.h"
#include "server/physics/mechanics/soft/laws/polar.h"
#include "server/physics/mechanics/soft/laws/symmetric_eigen.h"
#include "tests/soft/print_rows.h"

namespace prosector {
namespace {

using Random = std::mt19937_64;

double uniform(Random& random) {
  return std::uniform_real_distribution<double>(-1, 1)(random);
}

Mat3 random_matrix(Random& random) {
  return Mat3::NullaryExpr([&] { return uniform(random); });
}

Mat3 random_rotation(Random& random) {
  return Quat(uniform(random), uniform(random), uniform(random), uniform(random))
      .normalized()
      .toRotationMatrix();
}

double energy(const soft::ConstitutiveLaw& law, const Mat3& F) {
  double W = 0;
  law.energy_density({&F, 1}, {&W, 1});
  return W;
}
double dilatation(const soft::ConstitutiveLaw& law, const Mat3& F) {
  double theta = 0;
  law.dilatation({&F, 1}, {&theta, 1});
  return theta;
}
Mat3 stress(const soft::ConstitutiveLaw& law, const Mat3& F, double p = 0) {
  Mat3 P;
  law.stress({&F, 1}, {&p, 1}, {&P, 1});
  return P;
}
soft::Mat9 tangent(const soft::ConstitutiveLaw& law, const Mat3& F, double p = 0) {
  soft::Mat9 H;
  law.tangent({&F, 1}, {&p, 1}, {&H, 1});
  return H;
}
soft::Mat9 difference_tangent(const soft::ConstitutiveLaw& law, const Mat3& F, double p) {
  soft::Mat9 H;
  const double h = 1e-6;
  for (int i = 0; i < 9; ++i) {
    Mat3 dF = Mat3::Zero();
    dF.data()[i] = h;
    const Mat3 dP = (stress(law, F + dF, p) - stress(law, F - dF, p)) / (2 * h);
    H.col(i) = Eigen::Map<const Eigen::Matrix<double, 9, 1>>(dP.data());
  }
  return 0.5 * (H + H.transpose());
}

class Laws : public testing::TestWithParam<soft::LawRow> {
 protected:
  std::unique_ptr<soft::ConstitutiveLaw> law(double nu = 0.4, double E = 1) const {
    soft::Material material = soft::lame(E, nu);
    material.fiber_stiffness = 2 * E;
    material.fiber = Vec3(2, -1, 2) / 3;
    return GetParam().make(material);
  }
};
INSTANTIATE_TEST_SUITE_P(Table, Laws, testing::ValuesIn(soft::laws()),
                         [](const auto& row) { return std::string(row.param.name); });

TEST_P(Laws, RestIsFreeOfEnergyAndStress) {
  EXPECT_NEAR(energy(*law(), Mat3::Identity()), 0, 1e-15);
  EXPECT_LT(stress(*law(), Mat3::Identity()).norm(), 1e-14);
}

TEST_P(Laws, ReducesToHooke) {
  for (double nu : {-0.4, 0.0, 0.3, 0.45, 0.49}) {
    const soft::Lame c = soft::lame(1, nu);
    const soft::Mat9 H = tangent(*GetParam().make(c), Mat3::Identity());
    EXPECT_NEAR(H(0, 0), c.lambda + 2 * c.mu, 1e-9) << nu;
    EXPECT_NEAR(H(0, 4), c.lambda, 1e-9) << nu;
    EXPECT_NEAR(H(1, 1), c.mu, 1e-9) << nu;
    EXPECT_NEAR(H(1, 3), c.mu, 1e-9) << nu;
  }
}

TEST_P(Laws, StressIsTheGradientOfEnergy) {
  Random random(1);
  for (double nu : {0.0, 0.3, 0.45}) {
    const auto l = law(nu);
    for (int trial = 0; trial < 100; ++trial) {
      const Mat3 F = random_rotation(random) * (Mat3::Identity() + 0.6 * random_matrix(random));
      const Mat3 P = stress(*l, F), dF = random_matrix(random);
      const double h = 1e-6;
      const double slope = (energy(*l, F + h * dF) - energy(*l, F - h * dF)) / (2 * h);
      EXPECT_NEAR(P.cwiseProduct(dF).sum(), slope, 1e-7 * (1 + P.norm()));
      // A pressure adds that of the dilatation, whose gradient is also given by itself.
      Mat3 G;
      l->dilatation_gradient({&F, 1}, {&G, 1});
      const double growth = (dilatation(*l, F + h * dF) - dilatation(*l, F - h * dF)) / (2 * h);
      EXPECT_NEAR(G.cwiseProduct(dF).sum(), growth, 1e-7 * (1 + G.norm()));
      EXPECT_LT((stress(*l, F, 0.7) - P - 0.7 * G).norm(), 1e-12 * (1 + P.norm()));
    }
  }
}

TEST_P(Laws, TangentIsTheProjectedDerivativeOfStress) {
  Random random(2);
  int definite = 0;
  for (double nu : {0.0, 0.3, 0.45}) {
    const auto l = law(nu);
    // What pulls along fibres is semidefinite by itself: only the tissue around them is projected.
    const bool fibers = GetParam().name == std::string("fem_fibers");
    const auto tissue = fibers ? soft::make_law("fem_neo_hookean", soft::lame(1, nu)) : nullptr;
    for (int trial = 0; trial < 200; ++trial) {
      Mat3 F = random_rotation(random) * (Mat3::Identity() + 0.5 * random_matrix(random));
      // Corotational curvature is capped next to mirrored states, where R turns over.
      const Vec3 s = soft::symmetric_eigen(soft::polar(F).S).values;
      if (s.sum() - s.maxCoeff() < 0.1) continue;
      const double p = trial % 2 ? 3 * uniform(random) : 0;
      const soft::Mat9 whole = difference_tangent(*l, F, p);
      const soft::Mat9 isotropic = tissue ? difference_tangent(*tissue, F, p) : whole;
      const Eigen::SelfAdjointEigenSolver<soft::Mat9> exact(isotropic);
      // Where fibres go taut the tangent jumps.
      if (tissue && std::abs((F * Vec3(2, -1, 2) / 3).norm() - 1) < 1e-3) continue;
      const soft::Mat9 projected = exact.eigenvectors() * exact.eigenvalues().cwiseMax(0).asDiagonal() *
                                       exact.eigenvectors().transpose() +
                                   (whole - isotropic);
      definite += exact.eigenvalues().minCoeff() > 0;
      EXPECT_LT((tangent(*l, F, p) - projected).norm(), 1e-6 * (1 + projected.norm()));
    }
  }
  EXPECT_GT(definite, 0);
}

/// W holds λ/2·θ²: what of λ is taken from the points may act on θ instead.
TEST_P(Laws, LambdaActsOnTheDilatation) {
  Random random(9);
  const soft::Lame c = soft::lame(1, 0.45);
  const double part = c.lambda / 3;
  const auto whole = GetParam().make(c), less = GetParam().make(soft::Lame{c.lambda - part, c.mu});
  for (int trial = 0; trial < 100; ++trial) {
    const Mat3 F = Mat3::Identity() + 0.5 * random_matrix(random);
    const double theta = dilatation(*less, F);
    EXPECT_NEAR(energy(*less, F) + part / 2 * theta * theta, energy(*whole, F), 1e-12);
  }
}

TEST_P(Laws, TurningStoresNothing) {
  if (GetParam().name == std::string("fem_linear")) {
    // The known error: W = 2(μ + λ)(1 − cos θ)².
    const soft::Lame c = soft::lame(1, 0.4);
    const Mat3 turned = Eigen::AngleAxisd(0.7, Vec3::UnitZ()).toRotationMatrix();
    EXPECT_NEAR(energy(*law(), turned), 2 * (c.mu + c.lambda) * std::pow(1 - std::cos(0.7), 2), 1e-12);
    return;
  }
  Random random(3);
  for (int trial = 0; trial < 100; ++trial) {
    const Mat3 Q = random_rotation(random), F = Mat3::Identity() + 0.5 * random_matrix(random);
    EXPECT_NEAR(energy(*law(), Q), 0, 1e-12);
    EXPECT_NEAR(energy(*law(), Q * F), energy(*law(), F), 1e-12 * (1 + energy(*law(), F)));
    EXPECT_LT((stress(*law(), Q * F) - Q * stress(*law(), F)).norm(), 1e-11);
  }
}

TEST_P(Laws, FiniteAndSemidefiniteForEveryF) {
  Random random(4);
  std::vector<Mat3> extremes = {Mat3::Zero(),
                                -Mat3::Identity(),
                                Vec3(1, 1, 0).asDiagonal().toDenseMatrix(),
                                Vec3(1, 0, 0).asDiagonal().toDenseMatrix(),
                                Vec3(1, 1, -1).asDiagonal().toDenseMatrix(),
                                Vec3(2, 1e-9, -1e-9).asDiagonal().toDenseMatrix(),
                                1e-200 * Mat3::Identity(),
                                1e4 * Mat3::Identity(),
                                Mat3::Ones()};
  for (int i = 0; i < 300; ++i) extremes.push_back(std::pow(10, 3 * uniform(random)) * random_matrix(random));
  for (const Mat3& F : extremes) {
    EXPECT_TRUE(std::isfinite(energy(*law(), F)));
    EXPECT_TRUE(stress(*law(), F).allFinite());
    const soft::Mat9 H = tangent(*law(), F);
    ASSERT_TRUE(H.allFinite()) << F;
    const Eigen::SelfAdjointEigenSolver<soft::Mat9> eigen(H, Eigen::EigenvaluesOnly);
    EXPECT_GE(eigen.eigenvalues().minCoeff(), -1e-12 * (1 + eigen.eigenvalues().maxCoeff())) << F;
  }
}

TEST_P(Laws, BatchesEqualSingles) {
  Random random(5);
  std::vector<Mat3> F(37), P(37);
  std::vector<double> W(37);
  for (Mat3& f : F) f = Mat3::Identity() + random_matrix(random);
  law()->stress(F, {}, P);
  law()->energy_density(F, W);
  for (std::size_t i = 0; i < F.size(); ++i) {
    EXPECT_EQ(P[i], stress(*law(), F[i]));
    EXPECT_EQ(W[i], energy(*law(), F[i]));
  }
}

/// Uniaxial stretch l: the lateral stretch t that frees the sides, then P/E along.
std::pair<double, double> uniaxial(const soft::ConstitutiveLaw& law, double l) {
  double low = 0.5, high = 2;
  for (int i = 0; i < 100; ++i) {
    const double t = 0.5 * (low + high);
    (stress(law, Vec3(l, t, t).asDiagonal().toDenseMatrix())(1, 1) > 0 ? high : low) = t;
  }
  return {stress(law, Vec3(l, low, low).asDiagonal().toDenseMatrix())(0, 0), low};
}

TEST(LawsClosedForm, UniaxialStretch) {
  struct Case {
    const char* model;
    double nu, l, P, t;
  };
  const Case cases[] = {{"fem_neo_hookean", .3, .5, -.705854, 1.094647},
                        {"fem_neo_hookean", .45, .5, -1.109351, 1.331937},
                        {"fem_neo_hookean", .49, .5, -1.229091, 1.397806},
                        {"fem_neo_hookean", .3, 1.5, .404446, .867086},
                        {"fem_neo_hookean_polynomial", .3, .5, -.730769, 1.095445},
                        {"fem_neo_hookean_polynomial", .45, .5, -1.068966, 1.341641},
                        {"fem_neo_hookean_polynomial", .49, .5, -1.147651, 1.400000},
                        {"fem_neo_hookean_polynomial", .3, 1.5, .383191, .869227},
                        {"fem_corotational", .3, .5, -.5, 1.150},
                        {"fem_corotational", .45, .5, -.5, 1.225},
                        {"fem_corotational", .49, .5, -.5, 1.245},
                        {"fem_corotational", .3, 1.5, .5, .850},
                        {"fem_linear", .3, 1.5, .5, .850}};
  for (const Case& c : cases) {
    const auto [P, t] = uniaxial(*soft::make_law(c.model, soft::lame(1, c.nu)), c.l);
    EXPECT_NEAR(P, c.P, 1e-6) << c.model << " " << c.nu;
    EXPECT_NEAR(t, c.t, 1e-6) << c.model << " " << c.nu;
  }
}

TEST(LawsClosedForm, SimpleShear) {
  Mat3 F = Mat3::Identity();
  F(0, 1) = 0.5;
  const auto P12 = [&](const char* model, double nu) {
    return stress(*soft::make_law(model, soft::lame(1, nu)), F)(0, 1);
  };
  EXPECT_NEAR(P12("fem_corotational", .3), .206662, 1e-6);
  EXPECT_NEAR(P12("fem_corotational", .45), .223892, 1e-6);
  EXPECT_NEAR(P12("fem_neo_hookean_polynomial", .3), 0.5 * soft::lame(1, .3).mu, 1e-12);
}

/// Taut along the stretch, slack along a press, and across it as if there were none.
TEST(LawsClosedForm, FibresPullAlongThemselvesInTensionOnly) {
  const double k = 0.8;
  soft::Material material = soft::lame(1, .3);
  const auto bare = soft::make_law("fem_neo_hookean", material);
  material.fiber_stiffness = k;
  for (const bool along : {true, false}) {
    material.fiber = along ? Vec3::UnitX() : Vec3::UnitY();
    const auto law = soft::make_law("fem_fibers", material);
    for (double l : {0.6, 0.9, 1.2, 1.5}) {
      // Stretched to l along x; `t` frees y and `s` z. At l > 1 a fibre along y is slack, for t < 1.
      const auto [P, t] = uniaxial(*bare, l);
      if (along) {
        const Mat3 F = Vec3(l, t, t).asDiagonal();
        const double pull = l > 1 ? k / 2 * (l * l - 1) * l : 0;
        EXPECT_NEAR(stress(*law, F)(0, 0), P + pull, 1e-9);
        EXPECT_NEAR(stress(*law, F)(1, 1), 0, 1e-9);
      } else if (l > 1) {
        EXPECT_NEAR(stress(*law, Vec3(l, t, t).asDiagonal().toDenseMatrix())(0, 0), P, 1e-9);
      }
    }
  }
  // At small strain: E + k along (fibres at ν's mercy only sideways), E across.
  material.fiber = Vec3::UnitX();
  const auto [P, t] = uniaxial(*soft::make_law("fem_fibers", material), 1 + 1e-6);
  EXPECT_NEAR(P / 1e-6, 1 + k, 1e-4);
}

TEST(LawsErrors, NameWhatIsAllowed) {
  for (auto [E, nu] : {std::pair{0.0, 0.3}, {-1.0, 0.3}, {NAN, 0.3}, {1.0, 0.5}, {1.0, -1.0}, {1.0, NAN}}) {
    EXPECT_THROW(soft::lame(E, nu), InputError) << E << " " << nu;
  }
  try {
    soft::make_law("putty", soft::lame(1, .3));
    FAIL();
  } catch (const InputError& error) {
    for (const soft::LawRow& row : soft::laws())
      EXPECT_NE(std::string(error.what()).find(row.name), std::string::npos);
  }
}

TEST(PolarDecomposition, IsProperAndClosest) {
  Random random(6);
  for (int trial = 0; trial < 20000; ++trial) {
    Mat3 F = random_matrix(random);
    if (trial % 4 == 1) F.col(2) = F.col(0) + 1e-9 * uniform(random) * F.col(1);
    if (trial % 4 == 2) F = random_rotation(random) + 1e-8 * F;
    if (trial % 4 == 3) F *= std::pow(10, 100 * uniform(random));
    const soft::Polar p = soft::polar(F);
    EXPECT_LT((p.R.transpose() * p.R - Mat3::Identity()).norm(), 1e-14);
    EXPECT_GT(p.R.determinant(), 0.9);
    EXPECT_LT((p.R * p.S - F).norm(), 1e-9 * F.norm());
    const Vec3 s = soft::symmetric_eigen(p.S).values;  // closest: no two stretches sum to less than 0
    EXPECT_GT(s.sum() - s.maxCoeff(), -1e-9 * F.norm());
  }
  EXPECT_EQ(soft::polar(Mat3::Zero()).R, Mat3::Identity());
  EXPECT_EQ(soft::polar(Mat3::Constant(NAN)).R, Mat3::Identity());
}

TEST(SymmetricEigen, Decomposes) {
  Random random(7);
  for (int trial = 0; trial < 5000; ++trial) {
    Mat3 A = random_matrix(random);
    A = (A + A.transpose()).eval();
    if (trial % 2) A = Mat3::Identity() + 1e-9 * A;
    const soft::SymmetricEigen e = soft::symmetric_eigen(A);
    EXPECT_LT((e.vectors * e.values.asDiagonal() * e.vectors.transpose() - A).norm(), 1e-14 * (1 + A.norm()));
    EXPECT_LT((e.vectors.transpose() * e.vectors - Mat3::Identity()).norm(), 1e-14);
  }
}

}  // namespace
}  // namespace prosector
