#include "mortise/grids/output/xdmf.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "mortise/grids/core/error.hpp"
#include "mortise/grids/output/atomic_file.hpp"
#include "mortise/grids/output/hdf5_file.hpp"

namespace mortise {
namespace {

constexpr std::uint8_t vtk_hidden_cell = 32;  // vtkDataSetAttributes::HIDDENCELL

std::string step_file(int step) {
  char name[32];
  std::snprintf(name, sizeof name, "fields/step_%06d.h5", step);
  return name;
}

/// Where the data of grid k are in the file. Names of grids are free text, so folders are numbered.
std::string folder(std::size_t k) { return "grids/" + std::to_string(k) + "/"; }

HDF5File::Shape cell_shape(const GridSnapshot& grid) {
  return {static_cast<std::uint64_t>(grid.cells[1]), static_cast<std::uint64_t>(grid.cells[0])};
}
HDF5File::Shape node_shape(const GridSnapshot& grid) {
  return {static_cast<std::uint64_t>(grid.cells[1]) + 1, static_cast<std::uint64_t>(grid.cells[0]) + 1, 2};
}

std::string spaced(const HDF5File::Shape& shape) {
  std::string text;
  for (const auto extent : shape) {
    if (!text.empty()) text += ' ';
    text += std::to_string(extent);
  }
  return text;
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

std::string data_item(const std::string& file, const std::string& name, const HDF5File::Shape& shape, bool real) {
  return "<DataItem Dimensions=\"" + spaced(shape) + "\" Format=\"HDF\" " +
         (real ? "NumberType=\"Float\" Precision=\"8\"" : "NumberType=\"UChar\" Precision=\"1\"") + ">" + file + ":/" +
         name + "</DataItem>\n";
}

std::string cell_attribute(const std::string& file, const std::string& name, const std::string& set,
                           const GridSnapshot& grid, bool real) {
  return "          <Attribute Name=\"" + escaped(name) + "\" AttributeType=\"Scalar\" Center=\"Cell\">\n            " +
         data_item(file, set, cell_shape(grid), real) + "          </Attribute>\n";
}

/// The spatial collection of one step; only names and extents of the snapshot are used.
std::string collection(const Snapshot& snapshot) {
  const std::string file = step_file(snapshot.step);
  std::string xml = "      <Grid Name=\"step_" + std::to_string(snapshot.step) +
                    "\" GridType=\"Collection\" CollectionType=\"Spatial\">\n        <Time Value=\"" +
                    shortest(snapshot.time) + "\"/>\n";
  for (std::size_t k = 0; k < snapshot.grids.size(); ++k) {
    const GridSnapshot& grid = snapshot.grids[k];
    const std::string at = folder(k);
    HDF5File::Shape nodes = node_shape(grid);
    xml += "        <Grid Name=\"" + escaped(grid.name) + "\" GridType=\"Uniform\">\n";
    xml += "          <Topology TopologyType=\"2DSMesh\" Dimensions=\"" + spaced({nodes[0], nodes[1]}) + "\"/>\n";
    xml += "          <Geometry GeometryType=\"XY\">\n            " + data_item(file, at + "nodes", nodes, true) +
           "          </Geometry>\n";
    for (const auto& [name, values] : grid.fields) xml += cell_attribute(file, name, at + "fields/" + name, grid, true);
    xml += cell_attribute(file, "mask", at + "mask", grid, false);
    xml += cell_attribute(file, "vtkGhostType", at + "vtkGhostType", grid, false);
    xml += "        </Grid>\n";
  }
  return xml + "      </Grid>\n";
}

void write_grid(HDF5File& file, const std::string& at, const GridSnapshot& grid) {
  std::vector<double> nodes(2 * grid.node_count());
  for (std::size_t k = 0; k < grid.node_count(); ++k) {
    nodes[2 * k] = grid.x.at(k);
    nodes[2 * k + 1] = grid.y.at(k);
  }
  file.write(at + "nodes", nodes, node_shape(grid));
  file.write(at + "mask", grid.mask, cell_shape(grid));
  std::vector<std::uint8_t> hidden(grid.mask.size());
  std::transform(grid.mask.begin(), grid.mask.end(), hidden.begin(),
                 [](std::uint8_t mask) { return mask == mask_active ? std::uint8_t{0} : vtk_hidden_cell; });
  file.write(at + "vtkGhostType", hidden, cell_shape(grid));
  std::vector<std::string> names;
  for (const auto& [name, values] : grid.fields) {
    names.push_back(name);
    file.write(at + "fields/" + name, values, cell_shape(grid));
  }
  file.write_texts(at + "field_names", names);
  const std::vector<std::int64_t> dimension{grid.dimension};
  file.write(at + "dimension", dimension, {1});
  file.write(at + "solid", std::vector<std::int64_t>{grid.solid ? 1 : 0}, {1});
}

void write_polygons(HDF5File& file, const std::string& name, const std::vector<std::vector<Point<2>>>& polygons) {
  file.write_attribute("/", name, static_cast<std::int64_t>(polygons.size()));
  for (std::size_t k = 0; k < polygons.size(); ++k) {
    std::vector<double> points;
    for (const Point<2>& point : polygons[k]) points.insert(points.end(), {point.x(), point.y()});
    file.write(name + "/" + std::to_string(k), points, {polygons[k].size(), 2});
  }
}

std::vector<std::vector<Point<2>>> read_polygons(const HDF5File& file, const std::string& name) {
  std::vector<std::vector<Point<2>>> polygons;
  for (std::int64_t k = 0; k < file.integer_attribute("/", name); ++k) {
    const std::vector<double> points = file.read_doubles(name + "/" + std::to_string(k));
    polygons.emplace_back();
    for (std::size_t n = 0; n + 1 < points.size(); n += 2) polygons.back().emplace_back(points[n], points[n + 1]);
  }
  return polygons;
}

void write_fields(const std::string& path, const Snapshot& snapshot) {
  HDF5File file = HDF5File::create(path);
  file.write_attribute("/", "time", snapshot.time);
  file.write_attribute("/", "step", static_cast<std::int64_t>(snapshot.step));
  std::vector<std::string> names;
  for (const GridSnapshot& grid : snapshot.grids) names.push_back(grid.name);
  file.write_texts("grid_names", names);
  for (std::size_t k = 0; k < snapshot.grids.size(); ++k) write_grid(file, folder(k), snapshot.grids[k]);
  write_polygons(file, "outlines", snapshot.outlines);
  write_polygons(file, "surfaces", snapshot.surfaces);
  if (!snapshot.contours.empty()) write_polygons(file, "contours", snapshot.contours);
  file.close();
}

/// Time, step, names and extents, without data.
Snapshot read_frame(const HDF5File& file) {
  Snapshot snapshot;
  snapshot.time = file.double_attribute("/", "time");
  snapshot.step = static_cast<int>(file.integer_attribute("/", "step"));
  for (const std::string& name : file.read_texts("grid_names")) {
    const std::string at = folder(snapshot.grids.size());
    GridSnapshot grid;
    grid.name = name;
    const HDF5File::Shape shape = file.shape(at + "mask");
    grid.cells = {static_cast<int>(shape.at(1)), static_cast<int>(shape.at(0))};
    grid.dimension = static_cast<int>(file.read_integers(at + "dimension").at(0));
    grid.solid = file.has(at + "solid") && file.read_integers(at + "solid").at(0) != 0;
    for (const std::string& key : file.read_texts(at + "field_names")) grid.fields.push_back({key, {}});
    snapshot.grids.push_back(std::move(grid));
  }
  return snapshot;
}

void read_grid(const HDF5File& file, const std::string& at, GridSnapshot& grid) {
  const std::vector<double> nodes = file.read_doubles(at + "nodes");
  for (std::size_t k = 0; k + 1 < nodes.size(); k += 2) {
    grid.x.push_back(nodes[k]);
    grid.y.push_back(nodes[k + 1]);
  }
  grid.mask = file.read_bytes(at + "mask");
  for (auto& [name, values] : grid.fields) values = file.read_doubles(at + "fields/" + name);
}

}  // namespace

Snapshot read_snapshot(const std::string& path) {
  const HDF5File file = HDF5File::open(path);
  Snapshot snapshot = read_frame(file);
  for (std::size_t k = 0; k < snapshot.grids.size(); ++k) read_grid(file, folder(k), snapshot.grids[k]);
  snapshot.outlines = read_polygons(file, "outlines");
  snapshot.surfaces = read_polygons(file, "surfaces");
  if (file.has("contours")) snapshot.contours = read_polygons(file, "contours");
  return snapshot;
}

std::vector<std::string> series_files(const std::string& directory) {
  std::vector<std::pair<int, std::string>> found;
  std::error_code error;
  for (const auto& item : std::filesystem::directory_iterator(directory + "/fields", error)) {
    int step = 0;
    const std::string name = item.path().filename().string();
    if (std::sscanf(name.c_str(), "step_%d.h5", &step) == 1 && "fields/" + name == step_file(step))
      found.emplace_back(step, item.path().string());
  }
  std::sort(found.begin(), found.end());
  std::vector<std::string> paths;
  for (auto& [step, path] : found) paths.push_back(std::move(path));
  return paths;
}

SeriesWriter::SeriesWriter(std::string directory, double restart_time) : directory_(std::move(directory)) {
  make_folder(directory_ + "/fields");
  for (const std::string& path : series_files(directory_)) {
    try {
      const Snapshot frame = read_frame(HDF5File::open(path));
      if (frame.time <= restart_time) {
        entries_.push_back({frame.step, collection(frame)});
        continue;
      }
    } catch (const EnvironmentError&) {  // unreadable: not part of a series
    }
    std::filesystem::remove(path);
  }
  if (entries_.empty())
    std::filesystem::remove(index());
  else
    write_index();
}

void SeriesWriter::write(const Snapshot& snapshot) {
  const std::string path = directory_ + "/" + step_file(snapshot.step);
  write_fields(path, snapshot);
  std::erase_if(entries_, [&](const Entry& entry) { return entry.step == snapshot.step; });
  const auto after = [&](const Entry& entry) { return entry.step > snapshot.step; };
  entries_.insert(std::find_if(entries_.begin(), entries_.end(), after), {snapshot.step, collection(snapshot)});
  write_index();
}

void SeriesWriter::write_index() const {
  std::string xml =
      "<?xml version=\"1.0\" ?>\n<Xdmf Version=\"3.0\">\n  <Domain>\n"
      "    <Grid Name=\"mortise\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (const Entry& entry : entries_) xml += entry.xml;
  write_file(index(), xml + "    </Grid>\n  </Domain>\n</Xdmf>\n");
}

}  // namespace mortise
