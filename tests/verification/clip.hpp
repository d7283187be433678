#pragma once

#include <string>

namespace mortise::testing {

/// `solids` of a case: a clip whose two prongs are thrown against each other; they touch from t = .2 to .4.
inline const std::string thrown_clip =
    R"([{shape="polygon", fillet=0.03, corners=[[-0.5, -0.35], [0.5, -0.35], [0.5, -0.15], [-0.3, -0.15], )"
    R"([-0.3, 0.15], [0.5, 0.15], [0.5, 0.35], [-0.5, 0.35]], material={law="neo_hookean", density=3, lambda=1, )"
    R"(mu=10}, initial={kind="formula", velocity=[0, "(y > 0 ? -1 : 1)*2.5*max(x + 0.4, 0)^2"]}}])";

}  // namespace mortise::testing
