#include "mortise/coupler/contact_step.hpp"

#include <algorithm>
#include <cmath>

namespace mortise {
namespace {

/// Upper bound of the speed of a body's points.
template <int Dim>
double speed(const CoupledBody<Dim>& body, const BodyVector<Dim>& y) {
  double radius = 0;
  for (const WallFace<Dim>& face : body.faces) radius = std::max(radius, face.arm.norm());
  return y.template head<Dim>().norm() + (Dim == 2 ? std::abs(y[y.size() - 1]) * radius : 0);
}

template <int Dim>
class ContactStepper {
 public:
  ContactStepper(std::vector<CoupledBody<Dim>>&& bodies, BodyAdvance<Dim> advance, const WallLaw& law,
                 const ContactOptions& options)
      : bodies_(std::move(bodies)), advance_(advance), law_(law), options_(options) {
    if (!bodies_.empty()) options_.dt = bodies_.front().step.dt;
    for (const CoupledBody<Dim>& body : bodies_) step_.motions.push_back(advance_(body.step, body.faces, law_));
    step_.impulse.assign(bodies_.size(), BodyVector<Dim>::Zero());
  }

  ContactStep<Dim> solve(const GapSearch<Dim>& gaps) {
    if (gaps) contacts_ = gaps(options_.distance + 2 * options_.dt * fastest());
    if (!contacts_.empty()) {
      std::vector<double> normal_impulse = impact();
      const std::vector<double> pushing = contact();
      for (std::size_t c = 0; c < contacts_.size(); ++c) step_.count += normal_impulse[c] > 0 || pushing[c] > 0;
    }
    return std::move(step_);
  }

 private:
  double fastest() const {
    double largest = 0;
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      largest = std::max(
          {largest, speed(bodies_[i], bodies_[i].step.velocity), speed(bodies_[i], step_.motions[i].velocity)});
    return largest;
  }

  /// Inverse mass in an impact: M⁻¹, or for a body without mass what the fluid makes of an impulse within the step.
  BodyMatrix<Dim> impact_response(std::size_t i) const {
    const BodyStep<Dim>& step = bodies_[i].step;
    if (!traditional_possible(step)) return step_.motions[i].response;
    BodyMatrix<Dim> inverse = BodyMatrix<Dim>::Zero();
    for (int k = 0; k < step.mass.size(); ++k)
      if (!step.held[static_cast<std::size_t>(k)]) inverse(k, k) = 1 / step.mass[k];
    return inverse;
  }

  /// Changes y^n; returns the normal impulses.
  std::vector<double> impact() {
    std::vector<ContactBody<Dim>> touching;
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      touching.push_back({bodies_[i].position, bodies_[i].step.velocity, impact_response(i), traditional_possible(bodies_[i].step), bodies_[i].round});
    const ContactResult<Dim> result = resolve_contacts(touching, contacts_, options_);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (result.correction[i].isZero(0)) continue;
      bodies_[i].step.velocity += result.correction[i];
      step_.impulse[i] += result.impulse[i];
      step_.motions[i] = advance_(bodies_[i].step, bodies_[i].faces, law_);
    }
    return result.normal_impulse;
  }

  /// Contact forces during the step; returns the normal impulses λ.
  std::vector<double> contact() {
    ContactOptions plastic = options_;
    plastic.restitution = 0;
    std::vector<BodyVector<Dim>> impulse(bodies_.size(), BodyVector<Dim>::Zero());
    ContactResult<Dim> result;
    for (int iteration = 0; iteration < 30; ++iteration) {
      std::vector<ContactBody<Dim>> free;
      for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const BodyMotion<Dim>& motion = step_.motions[i];
        free.push_back({bodies_[i].position, motion.velocity - motion.response * impulse[i], motion.response, true, bodies_[i].round});
      }
      result = resolve_contacts(free, contacts_, plastic);
      if (!push(result.impulse, impulse)) break;
    }
    for (const int c : result.unresolved) step_.unresolved.push_back(contacts_[static_cast<std::size_t>(c)]);
    for (std::size_t i = 0; i < bodies_.size(); ++i) step_.impulse[i] += impulse[i];
    return result.normal_impulse;
  }

  /// Advances the bodies again where the contact impulse changed; false if none did beyond round-off.
  bool push(const std::vector<BodyVector<Dim>>& wanted, std::vector<BodyVector<Dim>>& impulse) {
    bool changed = false;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if ((wanted[i] - impulse[i]).norm() <= 1e-13 * wanted[i].norm()) continue;
      changed = true;
      impulse[i] = wanted[i];
      BodyStep<Dim> step = bodies_[i].step;
      for (BodyVector<Dim>& force : step.external) force += impulse[i] / step.dt;
      step_.motions[i] = advance_(step, bodies_[i].faces, law_);
    }
    return changed;
  }

  std::vector<CoupledBody<Dim>> bodies_;
  BodyAdvance<Dim> advance_;
  const WallLaw& law_;
  ContactOptions options_;
  std::vector<ContactPoint<Dim>> contacts_;
  ContactStep<Dim> step_;
};

}  // namespace

template <int Dim>
ContactStep<Dim> advance_bodies(std::vector<CoupledBody<Dim>> bodies, BodyAdvance<Dim> advance, const WallLaw& law,
                                const GapSearch<Dim>& gaps, ContactOptions options) {
  return ContactStepper<Dim>(std::move(bodies), advance, law, options).solve(gaps);
}

template ContactStep<1> advance_bodies<1>(std::vector<CoupledBody<1>>, BodyAdvance<1>, const WallLaw&,
                                          const GapSearch<1>&, ContactOptions);
template ContactStep<2> advance_bodies<2>(std::vector<CoupledBody<2>>, BodyAdvance<2>, const WallLaw&,
                                          const GapSearch<2>&, ContactOptions);

}  // namespace mortise
