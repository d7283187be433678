// Contact within a step: bodies that would come closer than the grids between them resolve exchange an impulse.
#include "mortise/coupler/gaps.hpp"
#include "mortise/coupler/simulation.hpp"

namespace mortise {

template <int Dim>
void Simulation<Dim>::touch(Motion& motion, const std::vector<BodyMatrix<Dim>>& responses, double dt) const {
  std::vector<GapBody<Dim>> shapes;
  std::vector<ContactBody<Dim>> bodies;
  double fastest = 0;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    shapes.push_back({setup_.fluid.bodies[b].shape.atlas.get(), setup_.bodies[b].outline.get(), bodies_[b].pose});
    bodies.push_back({bodies_[b].pose.position, motion.end[b], responses[b]});
    fastest = std::max(fastest, motion.end[b].template lpNorm<Eigen::Infinity>());
  }
  const std::vector<ContactPoint<Dim>> gaps =
      find_gaps<Dim>(shapes, setup_.fluid.domain, fluid_.grids().front().periodic, setup_.contact_gap + 4 * dt * fastest);
  if (gaps.empty()) return;
  const ContactResult<Dim> result =
      resolve_contacts(bodies, gaps, {.restitution = setup_.restitution, .distance = setup_.contact_gap, .dt = dt});
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    motion.end[b] += result.correction[b];
    motion.mean[b] += result.correction[b];
  }
  motion.contacts = result.count;
}

template void Simulation<1>::touch(Motion&, const std::vector<BodyMatrix<1>>&, double) const;
template void Simulation<2>::touch(Motion&, const std::vector<BodyMatrix<2>>&, double) const;

}  // namespace mortise
