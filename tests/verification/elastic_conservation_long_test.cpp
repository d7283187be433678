// Conservation and stability through an elastic interface over many steps.
#include "verification/elastic_conservation.hpp"

namespace mortise {
namespace {

using namespace testing;

TEST(ElasticConservationLong, NoiseInATube) { expect_conservation(100000); }

}  // namespace
}  // namespace mortise
