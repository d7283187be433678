#include <algorithm>
#include <charconv>

#include "mortise/cases/study/stress_parts.hpp"

namespace mortise::random_scenes {
namespace {

template <class Value, class Print>
std::string listed(const std::vector<Value>& values, Print&& print) {
  std::string text = "[";
  for (const Value& value : values) text += (text.size() > 1 ? ", " : "") + print(value);
  return text + "]";
}

std::string quoted(const std::string& word) { return '"' + word + '"'; }

}  // namespace

std::string digits(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

CaseText& CaseText::line(const std::string& text) {
  text_ += text + '\n';
  return *this;
}
CaseText& CaseText::table(const std::string& name) { return line("\n[" + name + "]"); }
CaseText& CaseText::entry(const std::string& name) { return line("\n[[" + name + "]]"); }
CaseText& CaseText::word(const std::string& key, const std::string& value) { return line(key + " = " + quoted(value)); }
CaseText& CaseText::words(const std::string& key, const std::vector<std::string>& values) {
  return line(key + " = " + listed(values, quoted));
}
CaseText& CaseText::number(const std::string& key, double value) { return line(key + " = " + digits(value)); }
CaseText& CaseText::numbers(const std::string& key, const std::vector<double>& values) {
  return line(key + " = " + (values.size() == 1 ? digits(values.front()) : listed(values, digits)));
}
CaseText& CaseText::yes(const std::string& key, bool value) { return line(key + (value ? " = true" : " = false")); }
CaseText& CaseText::plain(const std::string& key, const std::string& value) { return line(key + " = " + value); }

}  // namespace mortise::random_scenes
