#include "mortise/cases/study/table.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace mortise {
namespace {

Table example() {
  Table table;
  table.title = "cylinder_in_solid: errors";
  table.columns = {{"name", "quantity", ""}, {"error", "ρ error", "%.1e"}, {"count", "n", ""}};
  table.rows = {{std::string("a, b"), 1.2e-5, std::int64_t{7}},
                {std::string("c_1"), std::numeric_limits<double>::quiet_NaN(), {}}};
  return table;
}

TEST(Table, MarkdownColumnsAreAsWideAsTheirWidestEntry) {
  EXPECT_EQ(markdown(example()),
            "**cylinder_in_solid: errors**\n\n"
            "| quantity | ρ error | n   |\n"
            "| -------- | ------- | --- |\n"
            "| a, b     | 1.2e-05 | 7   |\n"
            "| c_1      |         |     |\n");
}

TEST(Table, LatexTranslatesWhatItCannotPrint) {
  const std::string text = latex(example());
  EXPECT_NE(text.find("\\caption{cylinder\\_in\\_solid: errors}"), std::string::npos);
  EXPECT_NE(text.find("quantity & $\\rho$ error & n \\\\"), std::string::npos);
  EXPECT_NE(text.find("a, b & $1.2\\cdot10^{-5}$ & $7$ \\\\"), std::string::npos);
}

TEST(Table, CsvHasFullPrecision) { EXPECT_EQ(csv(example()), "name,error,count\n\"a, b\",1.2e-05,7\nc_1,nan,\n"); }

}  // namespace
}  // namespace mortise
