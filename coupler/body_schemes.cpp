#include "mortise/coupler/body_schemes.hpp"

namespace mortise {

template <int Dim>
const Registry<BodyScheme<Dim>>& body_schemes() {
  static const Registry<BodyScheme<Dim>> registry("coupling scheme", {{"rigid", {&advance_added_mass<Dim>, false}},
                                                                      {"traditional", {&advance_traditional<Dim>, true}}});
  return registry;
}

template const Registry<BodyScheme<1>>& body_schemes<1>();
template const Registry<BodyScheme<2>>& body_schemes<2>();

}  // namespace mortise
