// Steps of a neo-Hookean solid.
#include "mortise/solid/system_step.hpp"

namespace mortise::elastic {

template ElasticStepResult system_step<Hyperelastic<NeoHookean>>(const ElasticTile&, double, const ElasticOptions&);

}  // namespace mortise::elastic
