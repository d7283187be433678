// Contact of rigid bodies with each other and with walls, by impulses along the contact normals. With the normal
// velocity v_c = e_b·y_b − e_a·y_a of contact c (negative: approaching), e = (n, r × n), and W = M⁻¹ of every body:
//
//   Δy = W Jᵀ λ,  λ_c ≥ 0,  v_c⁺ ≥ −ε v_c⁻,  λ_c (v_c⁺ + ε v_c⁻) = 0     (Newton's law of impact, restitution ε)
//
// for all contacts at once: of all admissible changes the one with the least energy ½ Δyᵀ M Δy. The energy does not
// grow and impulses are equal and opposite. Where that leaves bodies approaching at another contact, the law is applied
// again (a second impact), at last with ε = 0, after which nothing approaches. A body without mass bounces
// off nothing: ε = 0 where it touches one other thing only.
// Source: Moreau, Unilateral contact and dry friction in finite freedom dynamics, CISM 302 (1988). No friction.
#pragma once

#include <array>
#include <vector>

#include "mortise/coupler/body_vector.hpp"

namespace mortise {

/// A pair of closest points.
template <int Dim>
struct ContactPoint {
  int a = 0;                               // body
  int b = -1;                              // body, or −1: a wall at rest
  Point<Dim> normal = Point<Dim>::Zero();  // unit, from a to b
  Point<Dim> point = Point<Dim>::Zero();   // where the impulse acts
  double gap = 0;                          // distance; negative: overlapping
  std::array<double, Dim> shift{};         // by which b is moved here, where the domain is periodic
};

/// A body as contact sees it.
template <int Dim>
struct ContactBody {
  Point<Dim> position = Point<Dim>::Zero();            // centre of mass
  BodyVector<Dim> velocity = BodyVector<Dim>::Zero();  // before contact; held degrees with their prescribed velocity
  BodyMatrix<Dim> inverse_mass = BodyMatrix<Dim>::Zero();  // Δy per impulse, symmetric positive semidefinite; held: 0
  bool inert = true;   // false: has no mass of its own, and so nothing to bounce back with
  bool round = false;  // a circle: contact without friction cannot turn it, whatever round-off is in the contact points
};

struct ContactOptions {
  double restitution = 1;  // ε in [0, 1]: 1 elastic, 0 plastic
  double distance = 0;     // bodies with a gap up to this touch
  double dt = 0;           // a pair that would come closer than `distance` within dt touches, too
};

template <int Dim>
struct ContactResult {
  std::vector<BodyVector<Dim>> correction;  // Δy per body
  std::vector<BodyVector<Dim>> impulse;     // Jᵀλ per body: impulse and angular impulse
  std::vector<double> normal_impulse;       // λ ≥ 0 per contact
  int count = 0;                            // contacts with λ > 0
  std::vector<int> unresolved;              // contacts that still approach: squeezed by prescribed motions
};

/// Deterministic. No contacts, or none that touch: all zero.
template <int Dim>
ContactResult<Dim> resolve_contacts(const std::vector<ContactBody<Dim>>& bodies,
                                    const std::vector<ContactPoint<Dim>>& contacts, const ContactOptions& options);

}  // namespace mortise
