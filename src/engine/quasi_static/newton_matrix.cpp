// SPDX-License-Identifier: BSD-3-Clause
#include "src/engine/quasi_static/newton_matrix.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <utility>

namespace bagnold::quasi_static {

namespace {

/// Each change costs a solution; 8 and 32 take equally long (docs/data/performance/tried.md).
constexpr std::size_t most_changes = 16;

/// Blocks of a pair: the derivatives G_i, G_j of the velocity at the contact with respect to the
/// motion of each disk, and the matrix of the contact. With q = -z^ x r_ij along the tangent, for
/// the spins, G_i = (1, q d_i/(d_i + d_j)) and G_j = (-1, q d_j/(d_i + d_j)).
template <int unknowns>
struct PairBlocks {
  Eigen::Matrix<double, 2, unknowns> of_i, of_j;
  Eigen::Matrix2d contact;

  explicit PairBlocks(ActivePair const& pair) {
    auto const& r = pair.force.separation;
    Eigen::Vector2d const separation(r.x, r.y), n = separation.normalized();
    of_i.template leftCols<2>().setIdentity();
    of_j.template leftCols<2>() = -Eigen::Matrix2d::Identity();
    if constexpr (unknowns == 3) {
      Eigen::Vector2d const q(r.y, -r.x);
      of_i.col(2) = pair.share_i * q;
      of_j.col(2) = pair.share_j * q;
    }
    contact = pair.tangential * Eigen::Matrix2d::Identity() +
              (pair.normal - pair.tangential) * n * n.transpose();
  }
};

/// Calls visit(then, now) for each pair of two lists, by number; null where one list lacks it.
template <class Visit>
void each_of_both(std::vector<ActivePair> const& then, std::vector<ActivePair> const& now,
                  Visit const& visit) {
  auto a = then.begin(), b = now.begin();
  while (a != then.end() || b != now.end()) {
    bool const in_a = b == now.end() || (a != then.end() && a->number <= b->number);
    bool const in_b = a == then.end() || (b != now.end() && b->number <= a->number);
    visit(in_a ? &*a : nullptr, in_b ? &*b : nullptr);
    if (in_a) ++a;
    if (in_b) ++b;
  }
}

}  // namespace

template <bool Rotates>
void NewtonMatrix<Rotates>::order(std::uint32_t disks, std::vector<NearPair> const& contacts) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::uint32_t i = 0; i < disks; ++i) entries.emplace_back(i, i, 1);
  for (auto const& pair : contacts) {
    entries.emplace_back(pair.i, pair.j, 1);
    entries.emplace_back(pair.j, pair.i, 1);
  }
  Eigen::SparseMatrix<double> graph(disks, disks);
  graph.setFromTriplets(entries.begin(), entries.end());
  Eigen::AMDOrdering<int>::PermutationType eliminated;
  Eigen::AMDOrdering<int>{}(graph, eliminated);
  place_.resize(disks);
  for (std::int32_t k = 0; k < static_cast<std::int32_t>(disks); ++k)
    place_[static_cast<std::size_t>(eliminated.indices()[k])] = k;
  entries_.clear();
  pattern_ = {};
}

/// Places the blocks of the pairs; keeps the previous pattern if the pairs are the same.
template <bool Rotates>
void NewtonMatrix<Rotates>::lay_out(std::vector<ActivePair> const& active) {
  std::vector<Entry> entries;
  entries.reserve(active.size());
  for (auto const& pair : active) {
    auto const [column, row] = std::minmax(place_[pair.i], place_[pair.j]);
    entries.push_back({row, column});
  }
  if (entries == entries_ && !pattern_.row.empty()) return;
  entries_ = std::move(entries);
  pattern_ = FactorPattern(static_cast<std::int32_t>(place_.size()), entries_);
}

template <bool Rotates>
void NewtonMatrix<Rotates>::factorize(Eigen::VectorXd const& inertia,
                                      std::vector<ActivePair> const& active) {
  lay_out(active);
  factor_.clear(pattern_);
  auto const diagonal = [&](std::size_t disk) {
    return static_cast<std::size_t>(pattern_.first[static_cast<std::size_t>(place_[disk])]);
  };
  for (std::size_t i = 0; i < place_.size(); ++i)
    factor_.add(diagonal(i),
                inertia.segment<unknowns>(unknowns * static_cast<Eigen::Index>(i)).asDiagonal());
  for (std::size_t k = 0; k < active.size(); ++k) {
    PairBlocks<unknowns> const of(active[k]);
    factor_.add(diagonal(active[k].i), of.of_i.transpose() * of.contact * of.of_i);
    factor_.add(diagonal(active[k].j), of.of_j.transpose() * of.contact * of.of_j);
    auto const place = pattern_.find(entries_[k]);
    if (place_[active[k].i] > place_[active[k].j])
      factor_.add(place, of.of_i.transpose() * of.contact * of.of_j);
    else
      factor_.add(place, of.of_j.transpose() * of.contact * of.of_i);
  }
  factor_.factorize(pattern_);
  factorized_ = active;
  since_.clear();
}

template <bool Rotates>
bool NewtonMatrix<Rotates>::update(std::vector<ActivePair> const& active) {
  std::vector<RankChange> changes;
  std::vector<ActivePair const*> pairs;
  each_of_both(factorized_, active, [&](ActivePair const* then, ActivePair const* now) {
    Real const amount = (now ? now->normal : 0) - (then ? then->normal : 0);
    if (amount == 0) return;
    pairs.push_back(then ? then : now);
    changes.push_back({pairs.back()->number, amount, {}});
  });
  if (changes.size() > most_changes) return false;
  auto& known = since_.changes();
  for (std::size_t k = 0; k < changes.size(); ++k) {
    auto const same = std::ranges::find(known, changes[k].pair, &RankChange::pair);
    changes[k].column = same == known.end() ? column_of(*pairs[k]) : std::move(same->column);
  }
  known = std::move(changes);
  since_.factorize();
  return true;
}

/// L^-1 w
template <bool Rotates>
Eigen::VectorXd NewtonMatrix<Rotates>::column_of(ActivePair const& pair) const {
  auto const& r = pair.force.separation;
  Eigen::Vector2d const n = Eigen::Vector2d(r.x, r.y).normalized();
  Eigen::VectorXd w = Eigen::VectorXd::Zero(unknowns * static_cast<Eigen::Index>(place_.size()));
  w.template segment<2>(unknowns * place_[pair.i]) = n;
  w.template segment<2>(unknowns * place_[pair.j]) = -n;
  factor_.solve_lower(pattern_, w);
  return w;
}

template <bool Rotates>
Eigen::VectorXd NewtonMatrix<Rotates>::solve(Eigen::VectorXd const& right) const {
  Eigen::VectorXd ordered(right.size()), u(right.size());
  for (std::size_t i = 0; i < place_.size(); ++i)
    ordered.segment<unknowns>(unknowns * place_[i]) =
        right.segment<unknowns>(unknowns * static_cast<Eigen::Index>(i));
  factor_.solve_lower(pattern_, ordered);
  since_.correct(ordered);
  factor_.solve_upper(pattern_, ordered);
  for (std::size_t i = 0; i < place_.size(); ++i)
    u.segment<unknowns>(unknowns * static_cast<Eigen::Index>(i)) =
        ordered.segment<unknowns>(unknowns * place_[i]);
  return u;
}

template class NewtonMatrix<false>;
template class NewtonMatrix<true>;

}  // namespace bagnold::quasi_static
