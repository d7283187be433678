#include "mortise/coupler/contact.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "mortise/coupler/least_distance.hpp"

namespace mortise {
namespace {

constexpr int impacts = 20;  // successive impacts with restitution before the last, plastic one

/// B with W = B Bᵀ: in the variables x of Δy = B x the energy is ½|x|². Modes below 1e-10 (in units in which W has a
/// unit diagonal) do not move.
template <int Dim>
BodyMatrix<Dim> root(const BodyMatrix<Dim>& W) {
  const BodyVector<Dim> scale = W.diagonal().cwiseMax(0).cwiseSqrt();
  const BodyVector<Dim> inverse = scale.unaryExpr([](double s) { return s > 0 ? 1 / s : 0; });
  const Eigen::SelfAdjointEigenSolver<BodyMatrix<Dim>> eigen(inverse.asDiagonal() * W * inverse.asDiagonal());
  const BodyVector<Dim> kept =
      eigen.eigenvalues().unaryExpr([](double value) { return value > 1e-10 ? std::sqrt(value) : 0; });
  return scale.asDiagonal() * eigen.eigenvectors() * kept.asDiagonal();
}

template <int Dim>
class ContactSolver {
  static constexpr int dofs = Dim + rotations<Dim>;

 public:
  ContactSolver(const std::vector<ContactBody<Dim>>& bodies, const std::vector<ContactPoint<Dim>>& contacts,
                const ContactOptions& options)
      : bodies_(bodies), contacts_(contacts), options_(options), row_(bodies.size(), -1), touching_(contacts.size()) {
    for (const ContactBody<Dim>& body : bodies) velocity_.push_back(body.velocity);
    result_.correction.assign(bodies.size(), BodyVector<Dim>::Zero());
    result_.impulse.assign(bodies.size(), BodyVector<Dim>::Zero());
    result_.normal_impulse.assign(contacts.size(), 0.0);
  }

  ContactResult<Dim> solve() {
    for (int impact = 0; impact <= impacts; ++impact)
      if (!apply_impact(impact < impacts ? options_.restitution : 0)) break;
    for (std::size_t i = 0; i < bodies_.size(); ++i) result_.correction[i] = velocity_[i] - bodies_[i].velocity;
    result_.count = static_cast<int>(std::ranges::count_if(result_.normal_impulse, [](double p) { return p > 0; }));
    return std::move(result_);
  }

 private:
  BodyVector<Dim> direction(int body, const ContactPoint<Dim>& contact) const {
    const ContactBody<Dim>& of = bodies_[static_cast<std::size_t>(body)];
    Point<Dim> arm = Point<Dim>::Zero();  // round bodies: along the normal
    if (!of.round)
      for (int d = 0; d < Dim; ++d)
        arm[d] = contact.point[d] - of.position[d] - (body == contact.b ? contact.shift[static_cast<std::size_t>(d)] : 0);
    return generalized_normal<Dim>(contact.normal, arm);
  }

  double normal_velocity(const ContactPoint<Dim>& contact) const {
    double v = -direction(contact.a, contact).dot(velocity_[static_cast<std::size_t>(contact.a)]);
    if (contact.b >= 0) v += direction(contact.b, contact).dot(velocity_[static_cast<std::size_t>(contact.b)]);
    return v;
  }

  /// Adds the contacts that touch, or will within the step.
  void find_touching() {
    for (std::size_t c = 0; c < contacts_.size(); ++c) {
      const double closing = std::min(0.0, normal_velocity(contacts_[c])) * options_.dt;
      if (touching_[c] || contacts_[c].gap + closing > options_.distance) continue;
      touching_[c] = true;
      add_body(contacts_[c].a);
      if (contacts_[c].b >= 0) add_body(contacts_[c].b);
    }
  }

  void add_body(int body) {
    int& row = row_[static_cast<std::size_t>(body)];
    if (row >= 0) return;
    row = dofs * static_cast<int>(roots_.size());
    roots_.push_back(root<Dim>(bodies_[static_cast<std::size_t>(body)].inverse_mass));
  }

  const BodyMatrix<Dim>& root_of(int body) const {
    return roots_[static_cast<std::size_t>(row_[static_cast<std::size_t>(body)] / dofs)];
  }

  /// One impact at all touching contacts; false if nothing approaches.
  bool apply_impact(double restitution) {
    find_touching();
    const std::vector<std::size_t> list = touching_list();
    std::vector<double> change;  // least change of the normal velocities
    for (const std::size_t c : list)
      change.push_back(-(1 + (bounces(contacts_[c], list) ? restitution : 0)) * normal_velocity(contacts_[c]));
    if (list.empty() || *std::ranges::max_element(change) <= negligible()) return false;
    const LeastDistance least =
        least_distance(static_cast<std::size_t>(dofs) * roots_.size(), columns(list), change, negligible());
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      if (row_[i] >= 0)
        velocity_[i] += root_of(static_cast<int>(i)) *
                        Eigen::Map<const BodyVector<Dim>>(&least.x[static_cast<std::size_t>(row_[i])]);
    record(list, least);
    return true;
  }

  /// A body without mass has nothing to bounce back with. Between others it hands on what hits it.
  bool bounces(const ContactPoint<Dim>& contact, const std::vector<std::size_t>& touching) const {
    const auto can = [&](int body) {
      if (body < 0 || bodies_[static_cast<std::size_t>(body)].inert) return true;
      return std::ranges::count_if(touching, [&](std::size_t c) { return contacts_[c].a == body || contacts_[c].b == body; }) > 1;
    };
    return can(contact.a) && can(contact.b);
  }

  std::vector<std::size_t> touching_list() const {
    std::vector<std::size_t> list;
    for (std::size_t c = 0; c < contacts_.size(); ++c)
      if (touching_[c]) list.push_back(c);
    return list;
  }

  /// g with x = Σ λ g, one per contact of the list.
  std::vector<std::vector<double>> columns(const std::vector<std::size_t>& list) const {
    std::vector<std::vector<double>> G;
    for (const std::size_t c : list) {
      std::vector<double>& g = G.emplace_back(static_cast<std::size_t>(dofs) * roots_.size(), 0.0);
      const auto set_block = [&](int body, double sign) {
        const BodyVector<Dim> e = direction(body, contacts_[c]);
        const BodyVector<Dim> block = sign * root_of(body).transpose() * e;
        const auto& W = bodies_[static_cast<std::size_t>(body)].inverse_mass;
        if (block.norm() <= 1e-10 * W.diagonal().cwiseMax(0).cwiseSqrt().cwiseProduct(e).norm()) return;  // immovable
        std::ranges::copy(block, g.begin() + row_[static_cast<std::size_t>(body)]);
      };
      set_block(contacts_[c].a, -1);
      if (contacts_[c].b >= 0) set_block(contacts_[c].b, 1);
    }
    return G;
  }

  void record(const std::vector<std::size_t>& list, const LeastDistance& least) {
    for (std::size_t k = 0; k < list.size(); ++k) {
      const ContactPoint<Dim>& contact = contacts_[list[k]];
      const double lambda = least.multipliers[k];
      result_.normal_impulse[list[k]] += lambda;
      result_.impulse[static_cast<std::size_t>(contact.a)] -= lambda * direction(contact.a, contact);
      if (contact.b >= 0)
        result_.impulse[static_cast<std::size_t>(contact.b)] += lambda * direction(contact.b, contact);
    }
    result_.unresolved.clear();
    for (const int k : least.violated)
      result_.unresolved.push_back(static_cast<int>(list[static_cast<std::size_t>(k)]));
  }

  /// Approach velocities below this are round-off.
  double negligible() const {
    double largest = 0;
    for (std::size_t c = 0; c < contacts_.size(); ++c) {
      if (!touching_[c]) continue;
      for (const int body : {contacts_[c].a, contacts_[c].b})
        if (body >= 0)
          largest = std::max(largest, direction(body, contacts_[c])
                                          .cwiseAbs()
                                          .dot(bodies_[static_cast<std::size_t>(body)].velocity.cwiseAbs()));
    }
    return 1e-12 * largest;
  }

  const std::vector<ContactBody<Dim>>& bodies_;
  const std::vector<ContactPoint<Dim>>& contacts_;
  ContactOptions options_;
  std::vector<BodyVector<Dim>> velocity_;  // after the impacts so far
  std::vector<int> row_;                   // first row of a body in x; −1: touches nothing
  std::vector<BodyMatrix<Dim>> roots_;     // B of the bodies that touch, in the order of their rows
  std::vector<bool> touching_;             // per contact
  ContactResult<Dim> result_;
};

}  // namespace

template <int Dim>
ContactResult<Dim> resolve_contacts(const std::vector<ContactBody<Dim>>& bodies,
                                    const std::vector<ContactPoint<Dim>>& contacts, const ContactOptions& options) {
  return ContactSolver<Dim>(bodies, contacts, options).solve();
}

template ContactResult<1> resolve_contacts<1>(const std::vector<ContactBody<1>>&, const std::vector<ContactPoint<1>>&,
                                              const ContactOptions&);
template ContactResult<2> resolve_contacts<2>(const std::vector<ContactBody<2>>&, const std::vector<ContactPoint<2>>&,
                                              const ContactOptions&);

}  // namespace mortise
