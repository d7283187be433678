// What the random scenes of stress_scenes.hpp are put together from.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "mortise/cases/study/stress_dice.hpp"

namespace mortise::random_scenes {

/// The lines of a case file, written one after the other.
class CaseText {
 public:
  CaseText& table(const std::string& name);                          // [name]
  CaseText& entry(const std::string& name);                          // [[name]]
  CaseText& word(const std::string& key, const std::string& value);  // key = "value"
  CaseText& words(const std::string& key, const std::vector<std::string>& values);
  CaseText& number(const std::string& key, double value);
  CaseText& numbers(const std::string& key, const std::vector<double>& values);
  CaseText& yes(const std::string& key, bool value);
  CaseText& plain(const std::string& key, const std::string& value);  // key = value
  const std::string& text() const { return text_; }

 private:
  CaseText& line(const std::string& text);
  std::string text_;
};

/// A number as a case file may have it; read back it is the same double.
std::string digits(double value);

/// Units, grid and gas that everything else in a scene is measured by.
struct Stage {
  int dimension = 2;
  double length = 1;                           // unit of length
  double factor = 4;                           // h = 1/(10 factor)
  std::array<double, 2> low{}, high{};         // of the domain
  double density = 1, sound = 1, gamma = 1.4;  // gas at rest; p̃ = ρ c²/γ
  double p_inf = 0;
  double cfl = 0.9;
  bool gentle = false;  // disturbances are so weak that strains are small and every stable scheme must finish

  double spacing() const { return 0.1 / factor; }
  double shifted_pressure() const { return density * sound * sound / gamma; }
  double pressure() const { return shifted_pressure() - p_inf; }
};

/// How the gas begins, and an estimate of what that leads to.
struct Flow {
  std::string kind;                       // uniform, shock, …
  std::array<double, 4> state{};          // uniform, ahead
  double mach = 0;                        // shock
  double position = 0, angle = 0;         // of a front
  std::array<double, 4> left{}, right{};  // riemann
  std::string bump;                       // regions: pressure as a formula
  double fastest = 0;                     // |u| + c that is to be expected
};

struct Material {
  std::string law;
  double density = 0, lambda = 0, mu = 0;

  double speed() const { return std::sqrt((lambda + 2 * mu) / density); }
};

/// A scene in the making: its words in the order of a case file.
struct Scene {
  std::string what, scheme;
  bool robust = true;  // by design: a numerical failure of this scene is a defect of the program
  std::string text;
};

// stress_gas.cpp
Stage draw_stage(Dice& dice, int dimension);
/// `weakness`: by how much less than order one a gentle disturbance of the pressure has to be.
Flow draw_flow(Dice& dice, const Stage& stage, double weakness);
/// The end of a run of about `steps` steps of the gas.
double end_of(const Stage& stage, double fastest, int steps);
void write_head(CaseText& text, const std::string& title, const std::string& scheme, const Stage& stage);
void write_time(CaseText& text, const Stage& stage, double end);
void write_gas(CaseText& text, Dice& dice, const Stage& stage);
void write_flow(CaseText& text, const Stage& stage, const Flow& flow);
/// `repeat`: sides may be periodic.
void write_sides(CaseText& text, Dice& dice, const Stage& stage, const Flow& flow, bool repeat = true);
void write_output(CaseText& text, Dice& dice);

// stress_places.cpp
struct Place {
  std::array<double, 2> position{};
  double angle = 0;
};
/// A closed outline, within `radius` around its origin.
struct Shape {
  std::string shape;
  double radius = 0;
  std::vector<double> measures;                // radius; semi-axes; width, height
  std::vector<std::array<double, 2>> corners;  // polygon
  double fillet = 0;
  double area = 0;  // about
};
Shape draw_shape(Dice& dice, const Stage& stage, double largest, double least_width);
void write_shape(CaseText& text, const Shape& shape);
/// Shapes that fit into the domain with `gap` between each other and the edge; those that do not are taken out.
std::vector<Place> place_apart(Dice& dice, const Stage& stage, std::vector<Shape>& shapes, double gap);
/// Shapes side by side, gaps just wide enough for the grids; those that do not fit are taken out.
std::vector<Place> place_close(Dice& dice, const Stage& stage, std::vector<Shape>& shapes);

// stress_bodies.cpp
Scene line_bodies(Dice& dice, const std::string& title);
Scene plane_bodies(Dice& dice, const std::string& title);
Scene close_bodies(Dice& dice, const std::string& title);
void write_plane_body(CaseText& text, Dice& dice, const Stage& stage, const Shape& shape, const Place& place,
                      bool massive);

// stress_solids.cpp
Material draw_material(Dice& dice, const Stage& stage);
void write_material(CaseText& text, const Material& material);
/// By how much pressures must be smaller than the gas's for strains of the material to be small.
double weakness_of(const Stage& stage, const Material& material);
/// `round`: interfaces are circles or straight, on which the gas may have other faces than the solid.
void write_coupling(CaseText& text, Dice& dice, const Stage& stage, bool round);
std::string draw_interface_scheme(Dice& dice);
Scene plane_solids(Dice& dice, const std::string& title);
Scene mixed_plane(Dice& dice, const std::string& title);
Scene solids_alone(Dice& dice, const std::string& title);

// stress_layers.cpp
Scene line_strip(Dice& dice, const std::string& title);
Scene plane_strip(Dice& dice, const std::string& title);
Scene ring(Dice& dice, const std::string& title);
Scene hole(Dice& dice, const std::string& title);

// stress_gas.cpp
Scene gas_alone(Dice& dice, const std::string& title);

}  // namespace mortise::random_scenes
