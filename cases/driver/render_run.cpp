#include "mortise/cases/driver/render_run.hpp"

#include <cstdio>
#include <filesystem>

#include "mortise/cases/pictures/render.hpp"
#include "mortise/grids/core/error.hpp"
#include "mortise/grids/output/xdmf.hpp"

namespace mortise {

int render_run(const std::string& directory, const std::string& field) {
  const std::vector<std::string> files = series_files(directory);
  if (files.empty()) throw InputError("\"" + directory + "\" holds no fields to make pictures from (output.hdf5 = true and output.frames > 0 write them)");
  std::filesystem::create_directories(directory + "/frames");
  std::string path;
  for (std::size_t k = 0; k < files.size(); ++k) {
    const Snapshot snapshot = read_snapshot(files[k]);
    RenderOptions options;
    options.field = field;
    char number[32];
    std::snprintf(number, sizeof number, "%04zu", k);
    path = directory + "/frames/" + field + "_" + number + ".png";
    write_png(render(snapshot, options), path);
  }
  std::printf("%zu pictures, the last one %s\n", files.size(), path.c_str());
  return 0;
}

}  // namespace mortise
