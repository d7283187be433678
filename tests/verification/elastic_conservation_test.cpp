// Conservation through an elastic interface, whatever the ratio of the impedances.
#include "verification/elastic_conservation.hpp"

namespace mortise {
namespace {

using namespace testing;

TEST(ElasticConservation, NoiseInATube) { expect_conservation(1000); }

}  // namespace
}  // namespace mortise
