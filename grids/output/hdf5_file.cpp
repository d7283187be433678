#include "mortise/grids/output/hdf5_file.hpp"

#include <hdf5.h>

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <type_traits>
#include <utility>

#include "mortise/grids/core/error.hpp"
#include "mortise/grids/output/atomic_file.hpp"

namespace mortise {
namespace {

static_assert(std::is_same_v<hid_t, std::int64_t>);
static_assert(std::is_same_v<hsize_t, unsigned long long> && sizeof(hsize_t) == sizeof(std::uint64_t));

/// An HDF5 identifier and how to give it back.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  bool valid() const { return id_ >= 0; }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

Handle file_properties() {
  const hid_t list = H5Pcreate(H5P_FILE_CREATE);
  H5Pset_obj_track_times(list, false);
  return {list, H5Pclose};
}

Handle in_memory() {
  constexpr std::size_t growth = 1 << 20;  // bytes
  const hid_t list = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_fapl_core(list, growth, false);
  return {list, H5Pclose};
}

Handle dataset_properties() {
  const hid_t list = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_obj_track_times(list, false);
  return {list, H5Pclose};
}

Handle link_properties() {
  const hid_t list = H5Pcreate(H5P_LINK_CREATE);
  H5Pset_create_intermediate_group(list, 1);
  return {list, H5Pclose};
}

Handle text_type(std::size_t length) {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, length);
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return {type, H5Tclose};
}

std::size_t volume(const HDF5File::Shape& shape) {
  return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
}

/// Failures are reported by our exceptions, not by the library's own print-out.
void silence() {
  static const herr_t silent = H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  static_cast<void>(silent);
}

}  // namespace

HDF5File HDF5File::create(const std::string& path) {
  silence();
  const Handle properties = file_properties(), access = in_memory();
  HDF5File file(path, H5Fcreate(path.c_str(), H5F_ACC_TRUNC, properties, access), true);
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code error;
  if (file.file_ < 0 || !(folder.empty() || std::filesystem::is_directory(folder, error))) file.fail("create", "");
  return file;
}

HDF5File HDF5File::open(const std::string& path) {
  silence();
  HDF5File file(path, H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), false);
  if (file.file_ < 0) file.fail("read", "");
  return file;
}

HDF5File::HDF5File(HDF5File&& other) noexcept
    : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)), created_(other.created_) {}

HDF5File::~HDF5File() {
  if (file_ >= 0) H5Fclose(file_);
}

void HDF5File::close(Durable durable) {
  std::string image;
  if (created_) {
    const auto size = H5Fflush(file_, H5F_SCOPE_LOCAL) < 0 ? ssize_t{-1} : H5Fget_file_image(file_, nullptr, 0);
    if (size < 0) fail("put together", "");
    image.resize(static_cast<std::size_t>(size));
    if (H5Fget_file_image(file_, image.data(), image.size()) != size) fail("put together", "");
  }
  H5Fclose(std::exchange(file_, -1));
  if (created_) write_file(path_, image, durable);
}

void HDF5File::fail(const std::string& what, const std::string& name) const {
  throw EnvironmentError("cannot " + what + (name.empty() ? "" : " \"" + name + "\" in") + " the HDF5 file \"" + path_ +
                         "\"");
}

void HDF5File::write_raw(const std::string& name, hid_t type, const void* values, std::size_t count,
                         const Shape& shape) {
  if (volume(shape) != count) fail("write (data do not fill the shape)", name);
  const std::vector<hsize_t> extent(shape.begin(), shape.end());
  const Handle space(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr), H5Sclose);
  const Handle properties = dataset_properties(), links = link_properties();
  const Handle set(H5Dcreate2(file_, name.c_str(), type, space, links, properties, H5P_DEFAULT), H5Dclose);
  if (!set.valid()) fail("write", name);
  if (count > 0 && H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0) fail("write", name);
}

void HDF5File::write(const std::string& name, std::span<const double> values, const Shape& shape) {
  write_raw(name, H5T_NATIVE_DOUBLE, values.data(), values.size(), shape);
}
void HDF5File::write(const std::string& name, std::span<const std::int64_t> values, const Shape& shape) {
  write_raw(name, H5T_NATIVE_INT64, values.data(), values.size(), shape);
}
void HDF5File::write(const std::string& name, std::span<const std::uint8_t> values, const Shape& shape) {
  write_raw(name, H5T_NATIVE_UINT8, values.data(), values.size(), shape);
}

void HDF5File::write_texts(const std::string& name, const std::vector<std::string>& texts) {
  std::size_t length = 1;
  for (const std::string& text : texts) length = std::max(length, text.size());
  std::vector<char> padded(length * texts.size(), '\0');
  for (std::size_t k = 0; k < texts.size(); ++k)
    std::copy(texts[k].begin(), texts[k].end(), padded.begin() + static_cast<std::ptrdiff_t>(k * length));
  const Handle type = text_type(length);
  write_raw(name, type, padded.data(), texts.size(), {texts.size()});
}

void HDF5File::write_attribute(const std::string& object, const std::string& name, double value) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose), owner(H5Oopen(file_, object.c_str(), H5P_DEFAULT), H5Oclose);
  const Handle attribute(H5Acreate2(owner, name.c_str(), H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  if (!attribute.valid() || H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value) < 0) fail("write", object + ":" + name);
}

void HDF5File::write_attribute(const std::string& object, const std::string& name, std::int64_t value) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose), owner(H5Oopen(file_, object.c_str(), H5P_DEFAULT), H5Oclose);
  const Handle attribute(H5Acreate2(owner, name.c_str(), H5T_NATIVE_INT64, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  if (!attribute.valid() || H5Awrite(attribute, H5T_NATIVE_INT64, &value) < 0) fail("write", object + ":" + name);
}

bool HDF5File::has(const std::string& name) const {
  for (std::size_t end = name.find('/', 1);; end = name.find('/', end + 1)) {
    if (H5Lexists(file_, name.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
    if (end == std::string::npos) return true;
  }
}

HDF5File::Shape HDF5File::shape(const std::string& name) const {
  const Handle set(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!set.valid()) fail("read", name);
  const Handle space(H5Dget_space(set), H5Sclose);
  const int rank = H5Sget_simple_extent_ndims(space);
  if (rank < 0) fail("read", name);
  std::vector<hsize_t> extent(static_cast<std::size_t>(rank));
  H5Sget_simple_extent_dims(space, extent.data(), nullptr);
  return {extent.begin(), extent.end()};
}

template <class T>
std::vector<T> HDF5File::read_raw(const std::string& name, hid_t type) const {
  std::vector<T> values(volume(shape(name)));
  const Handle set(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!values.empty() && H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) fail("read", name);
  return values;
}

std::vector<double> HDF5File::read_doubles(const std::string& name) const {
  return read_raw<double>(name, H5T_NATIVE_DOUBLE);
}
std::vector<std::int64_t> HDF5File::read_integers(const std::string& name) const {
  return read_raw<std::int64_t>(name, H5T_NATIVE_INT64);
}
std::vector<std::uint8_t> HDF5File::read_bytes(const std::string& name) const {
  return read_raw<std::uint8_t>(name, H5T_NATIVE_UINT8);
}

std::vector<std::string> HDF5File::read_texts(const std::string& name) const {
  const std::size_t count = volume(shape(name));
  const Handle set(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose);
  const Handle type(H5Dget_type(set), H5Tclose);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0) fail("read", name);
  const std::size_t length = H5Tget_size(type);
  std::vector<char> padded(count * length);
  if (count > 0 && H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, padded.data()) < 0) fail("read", name);
  std::vector<std::string> texts;
  for (std::size_t k = 0; k < count; ++k) {
    texts.emplace_back(padded.data() + k * length, length);
    texts.back().resize(texts.back().find_last_not_of('\0') + 1);
  }
  return texts;
}

double HDF5File::double_attribute(const std::string& object, const std::string& name) const {
  double value = 0;
  const Handle attribute(H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  if (!attribute.valid() || H5Aread(attribute, H5T_NATIVE_DOUBLE, &value) < 0) fail("read", object + ":" + name);
  return value;
}

std::int64_t HDF5File::integer_attribute(const std::string& object, const std::string& name) const {
  std::int64_t value = 0;
  const Handle attribute(H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  if (!attribute.valid() || H5Aread(attribute, H5T_NATIVE_INT64, &value) < 0) fail("read", object + ":" + name);
  return value;
}

}  // namespace mortise
