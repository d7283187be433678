// What every study leaves in its directory: study.csv, study.json, study.md, study.tex and study.png.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mortise/cases/study/table.hpp"

namespace mortise {

/// `data` in full precision, for programs; `tables` for people; numbers that are not finite become null.
struct StudyFiles {
  nlohmann::ordered_json data;
  Table values;               // study.csv
  std::vector<Table> tables;  // study.md, study.tex
};

/// Writes them, prints the tables, and lets cases/study/plot.py make the picture (with a warning where there is no
/// Python with matplotlib). Throws EnvironmentError.
void write_study(const StudyFiles& files, const std::string& directory, const std::string& cases_root);

}  // namespace mortise
