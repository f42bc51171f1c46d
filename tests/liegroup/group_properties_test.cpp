/// The property suite for every group.

#include "group_properties.hpp"

namespace liesl::test::group_properties_test {

using Groups = testing::Types<SO3, SE2, SE3, Rn<1>, Rn<3>, R3xSO3, Product<SE2, Rn<2>>,
                              Product<Rn<1>, SO3, Rn<2>>>;
INSTANTIATE_TYPED_TEST_SUITE_P(AllGroups, GroupProperties, Groups);

}  // namespace liesl::test::group_properties_test
