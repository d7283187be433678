// Steps of a Saint Venant-Kirchhoff solid.
#include "mortise/solid/system_step.hpp"

namespace mortise::elastic {

template ElasticStepResult system_step<Hyperelastic<SaintVenantKirchhoff>>(const ElasticTile&, double,
                                                                           const ElasticOptions&);

}  // namespace mortise::elastic
