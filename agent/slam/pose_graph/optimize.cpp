// SPDX-License-Identifier: MIT
// All that knows Ceres.
#include "agent/slam/pose_graph/optimize.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>
#include <ceres/ceres.h>
#include <ceres/rotation.h>

#include "agent/slam/pose_graph/check_pose_graph.h"
#include "agent/slam/pose_graph/elimination_order.h"
#include "sim/base/error.h"

// OpenBLAS' and OpenMP's own; not there with another BLAS, and a CHOLMOD without threads.
extern "C" {
// NOLINTBEGIN(readability-identifier-naming)
__attribute__((weak)) int openblas_get_num_threads();
__attribute__((weak)) void openblas_set_num_threads(int threads);
__attribute__((weak)) int omp_get_max_active_levels();
__attribute__((weak)) void omp_set_max_active_levels(int levels);
// NOLINTEND(readability-identifier-naming)
}

namespace bulletnav::agent {
namespace {

/// L^T of information = L * L^T, with which |L^T e|^2 = e^T * information * e.
template <class Matrix>
Matrix WeightOf(const Matrix& information) {
  return information.llt().matrixU();
}

template <class T>
using Vector3 = Eigen::Matrix<T, 3, 1>;

/// x, y, yaw. Yaws are free numbers while they are optimised.
class PlanarError {
 public:
  using Pose = sim::PlanarPose;
  static constexpr int kNumbers = 3;

  explicit PlanarError(const PoseEdge<Pose>& edge)
      : back_(sim::Inverse(edge.measured)), weight_(WeightOf(edge.information)) {}

  template <class T>
  bool operator()(const T* from, const T* to, T* out) const {
    using std::cos;
    using std::floor;
    using std::sin;
    const T c = cos(from[2]);
    const T s = sin(from[2]);
    const T dx = to[0] - from[0];
    const T dy = to[1] - from[1];
    const T x = c * dx + s * dy;
    const T y = c * dy - s * dx;
    const T turn = to[2] - from[2] + back_.yaw;
    const double bc = std::cos(back_.yaw);
    const double bs = std::sin(back_.yaw);
    const Vector3<T> error(bc * x - bs * y + back_.x, bs * x + bc * y + back_.y,
                           turn - 2.0 * sim::kPi * floor((turn + sim::kPi) / (2.0 * sim::kPi)));
    Eigen::Map<Vector3<T>> weighted(out);
    weighted = weight_ * error;
    return true;
  }

  static std::array<double, kNumbers> NumbersOf(const Pose& pose) {
    return {pose.x, pose.y, pose.yaw};
  }
  static Pose PoseOf(const std::array<double, kNumbers>& numbers) {
    return {numbers[0], numbers[1], sim::WrapAngle(numbers[2])};
  }
  static std::unique_ptr<ceres::Manifold> MakeManifold() { return nullptr; }

 private:
  Pose back_;  // inverse of what was measured
  Eigen::Matrix3d weight_;
};

/// x, y, z and the quaternion's x, y, z, w.
class SpatialError {
 public:
  using Pose = SpatialPose;
  static constexpr int kNumbers = 7;

  explicit SpatialError(const PoseEdge<Pose>& edge)
      : back_(Inverse(edge.measured)), weight_(WeightOf(edge.information)) {}

  template <class T>
  bool operator()(const T* from, const T* to, T* out) const {
    using Rotation = Eigen::Quaternion<T>;
    using ConstRotation = Eigen::Map<const Rotation>;
    using ConstVector = Eigen::Map<const Vector3<T>>;
    const Rotation to_from = ConstRotation(from + 3).conjugate();
    const Vector3<T> seen = to_from * (ConstVector(to) - ConstVector(from));
    const Rotation back = back_.rotation.cast<T>();
    const Rotation turn = back * (to_from * ConstRotation(to + 3));
    const std::array<T, 4> wxyz = {turn.w(), turn.x(), turn.y(), turn.z()};
    Eigen::Matrix<T, 6, 1> error;
    error.template head<3>() = back * seen + back_.position.cast<T>();
    ceres::QuaternionToAngleAxis(wxyz.data(), error.data() + 3);
    Eigen::Map<Eigen::Matrix<T, 6, 1>> weighted(out);
    weighted = weight_ * error;
    return true;
  }

  static std::array<double, kNumbers> NumbersOf(const Pose& pose) {
    const Eigen::Quaterniond q = pose.rotation.normalized();
    return {pose.position.x(), pose.position.y(), pose.position.z(), q.x(), q.y(), q.z(), q.w()};
  }
  static Pose PoseOf(const std::array<double, kNumbers>& n) {
    return {{n[0], n[1], n[2]}, Eigen::Quaterniond(n[6], n[3], n[4], n[5]).normalized()};
  }
  static std::unique_ptr<ceres::Manifold> MakeManifold() {
    using Manifold =
        ceres::ProductManifold<ceres::EuclideanManifold<3>, ceres::EigenQuaternionManifold>;
    return std::make_unique<Manifold>();
  }

 private:
  Pose back_;
  PoseMatrix<Pose> weight_;
};

template <class Pose>
struct ErrorOf;
template <>
struct ErrorOf<sim::PlanarPose> {
  using Type = PlanarError;
};
template <>
struct ErrorOf<SpatialPose> {
  using Type = SpatialError;
};

std::unique_ptr<ceres::LossFunction> LossOf(const OptimizeOptions& options) {
  switch (options.kernel) {
    case RobustKernel::kNone:
      return nullptr;
    case RobustKernel::kHuber:
      return std::make_unique<ceres::HuberLoss>(options.kernel_width);
    case RobustKernel::kCauchy:
      return std::make_unique<ceres::CauchyLoss>(options.kernel_width);
  }
  return nullptr;
}

/// Ceres' problem of a graph and the numbers it works on.
template <class Pose>
class GraphProblem {
 public:
  using Error = typename ErrorOf<Pose>::Type;
  using Cost =
      ceres::AutoDiffCostFunction<Error, kFreedoms<Pose>, Error::kNumbers, Error::kNumbers>;

  GraphProblem(const PoseGraph<Pose>& graph, const PoseGraphLinks& links,
               const OptimizeOptions& options)
      : manifold_(Error::MakeManifold()), loss_(LossOf(options)), problem_(Borrowing()) {
    numbers_.reserve(graph.vertices.size());  // Ceres keeps pointers into it
    for (const PoseVertex<Pose>& vertex : graph.vertices) {
      numbers_.push_back(Error::NumbersOf(vertex.pose));
      problem_.AddParameterBlock(numbers_.back().data(), Error::kNumbers, manifold_.get());
    }
    costs_.reserve(graph.edges.size());
    for (std::size_t i = 0; i < graph.edges.size(); ++i) AddEdge(graph.edges[i], links.ends[i]);
    Fix(graph, links);
  }

  /// The vertices are eliminated in `order`, or if that is empty in one of Ceres' choice.
  ceres::Solver::Summary Solve(ceres::Solver::Options options, const std::vector<int>& order) {
    if (!order.empty()) options.linear_solver_ordering = GroupsOf(order);
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem_, &summary);
    return summary;
  }

  Pose PoseOf(std::size_t vertex) const { return Error::PoseOf(numbers_[vertex]); }

 private:
  static ceres::Problem::Options Borrowing() {
    ceres::Problem::Options options;
    options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    options.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    return options;
  }

  /// Each vertex is a group of its own, so that Ceres has nothing left to choose.
  std::shared_ptr<ceres::ParameterBlockOrdering> GroupsOf(const std::vector<int>& order) {
    auto groups = std::make_shared<ceres::ParameterBlockOrdering>();
    int group = 0;
    for (const int vertex : order) {
      groups->AddElementToGroup(numbers_[static_cast<std::size_t>(vertex)].data(), group++);
    }
    return groups;
  }

  void AddEdge(const PoseEdge<Pose>& edge, std::pair<int, int> ends) {
    costs_.push_back(std::make_unique<Cost>(std::make_unique<Error>(edge).release()));
    problem_.AddResidualBlock(costs_.back().get(), edge.is_loop ? loss_.get() : nullptr,
                              numbers_[static_cast<std::size_t>(ends.first)].data(),
                              numbers_[static_cast<std::size_t>(ends.second)].data());
  }

  void Fix(const PoseGraph<Pose>& graph, const PoseGraphLinks& links) {
    std::vector<bool> has_fixed(static_cast<std::size_t>(links.pieces), false);
    const auto fix = [&](std::size_t vertex) {
      problem_.SetParameterBlockConstant(numbers_[vertex].data());
      has_fixed[static_cast<std::size_t>(links.piece[vertex])] = true;
    };
    for (std::size_t i = 0; i < graph.vertices.size(); ++i) {
      if (graph.vertices[i].is_fixed) fix(i);
    }
    for (std::size_t i = 0; i < graph.vertices.size(); ++i) {
      if (!has_fixed[static_cast<std::size_t>(links.piece[i])]) fix(i);
    }
  }

  std::vector<std::array<double, Error::kNumbers>> numbers_;
  std::vector<std::unique_ptr<Cost>> costs_;
  std::unique_ptr<ceres::Manifold> manifold_;
  std::unique_ptr<ceres::LossFunction> loss_;
  ceres::Problem problem_;
};

/// From so many vertices on the supernodes of CHOLMOD, which works with BLAS, are faster. Its last
/// bits are those of BLAS' kernels; Eigen's are the same on all processors.
constexpr std::size_t kManyVertices = 2000;

/// One thread of OpenBLAS and of CHOLMOD while it lives: more would change the order of sums, and
/// wait for each other where processors are shared. CHOLMOD asks for four, whatever the user says;
/// no active level of OpenMP leaves it one.
class OneThread {
 public:
  OneThread() {
    SetBlas(1);
    SetLevels(0);
  }
  ~OneThread() {
    SetBlas(blas_before_);
    SetLevels(levels_before_);
  }
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;
  OneThread(OneThread&&) = delete;
  OneThread& operator=(OneThread&&) = delete;

 private:
  static void SetBlas(int threads) {
    if (openblas_set_num_threads != nullptr) openblas_set_num_threads(threads);
  }
  static void SetLevels(int levels) {
    if (omp_set_max_active_levels != nullptr) omp_set_max_active_levels(levels);
  }
  int blas_before_ = openblas_get_num_threads != nullptr ? openblas_get_num_threads() : 1;
  int levels_before_ = omp_get_max_active_levels != nullptr ? omp_get_max_active_levels() : 1;
};

ceres::Solver::Options SolverOptions(int max_iterations, std::size_t vertices) {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.sparse_linear_algebra_library_type =
      vertices < kManyVertices ? ceres::EIGEN_SPARSE : ceres::SUITE_SPARSE;
  options.num_threads = 1;
  options.max_num_iterations = max_iterations;
  // Nearly Gauss and Newton's method where that works, which halves the iterations.
  options.initial_trust_region_radius = 1e8;
  options.function_tolerance = 1e-9;
  options.gradient_tolerance = 1e-10;
  options.parameter_tolerance = 1e-12;
  options.logging_type = ceres::SILENT;
  return options;
}

void Check(const OptimizeOptions& options) {
  if (!(options.kernel_width > 0.0)) throw sim::Error("a robust kernel's width must be positive");
  if (options.max_iterations < 1) throw sim::Error("optimising takes at least one iteration");
}

}  // namespace

template <class Pose>
OptimizeSummary Optimize(const OptimizeOptions& options, PoseGraph<Pose>* graph) {
  Check(options);
  const PoseGraphLinks links = LinksOf(*graph);
  if (!options.allow_pieces) CheckOnePiece(*graph, links);
  GraphProblem<Pose> problem(*graph, links, options);
  const OneThread one_thread;
  const std::size_t vertices = graph->vertices.size();
  std::vector<int> order;
  if (vertices >= kManyVertices) order = EliminationOrder(static_cast<int>(vertices), links.ends);
  const ceres::Solver::Summary summary =
      problem.Solve(SolverOptions(options.max_iterations, vertices), order);
  if (!summary.IsSolutionUsable()) {
    throw sim::Error("the pose graph cannot be optimised: " + summary.message +
                     "; look for information of extreme size");
  }
  for (std::size_t i = 0; i < graph->vertices.size(); ++i) {
    if (!graph->vertices[i].is_fixed) graph->vertices[i].pose = problem.PoseOf(i);
  }
  // The first entry is the state before any step.
  const int iterations = std::max(0, static_cast<int>(summary.iterations.size()) - 1);
  return {summary.initial_cost, summary.final_cost, iterations,
          summary.termination_type == ceres::CONVERGENCE, links.pieces};
}

template OptimizeSummary Optimize(const OptimizeOptions&, PlanarPoseGraph*);
template OptimizeSummary Optimize(const OptimizeOptions&, SpatialPoseGraph*);

}  // namespace bulletnav::agent
