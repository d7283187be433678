// Steps of linear elasticity.
#include "mortise/solid/system_step.hpp"

namespace mortise::elastic {

template ElasticStepResult system_step<Linear>(const ElasticTile&, double, const ElasticOptions&);

}  // namespace mortise::elastic
