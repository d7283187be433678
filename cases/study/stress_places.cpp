// Shapes, and places for them in the domain.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "mortise/cases/study/stress_parts.hpp"

namespace mortise::random_scenes {
namespace {

double distance(const std::array<double, 2>& a, const std::array<double, 2>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

/// A convex polygon: corners on an ellipse.
void draw_corners(Dice& dice, Shape& shape, double radius) {
  const int n = dice.whole(3, 6);
  const double flat = dice.between(0.6, 1);
  for (int k = 0; k < n; ++k) {
    const double angle = 2 * std::numbers::pi * (k + (n > 3 ? dice.between(-0.2, 0.2) : 0.0)) / n;
    shape.corners.push_back({Dice::rounded(radius * std::cos(angle)), Dice::rounded(flat * radius * std::sin(angle))});
  }
  shape.area = 1.5 * flat * radius * radius;
}

}  // namespace

Shape draw_shape(Dice& dice, const Stage& stage, double largest, double least_width) {
  Shape shape;
  shape.shape = dice.word({"circle", "circle", "ellipse", "stick", "stick", "rectangle", "polygon"});
  const double least = std::min(0.5 * least_width, 0.8 * largest);
  const double a = Dice::rounded(stage.length * dice.between(std::max(least, 0.4 * largest), largest));
  const double b = Dice::rounded(std::max(stage.length * least, a * dice.between(0.15, 1)));
  if (shape.shape == "circle") {
    shape.measures = {a};
    shape.area = std::numbers::pi * a * a;
  } else if (shape.shape == "ellipse") {
    shape.measures = {a, b};
    shape.area = std::numbers::pi * a * b;
  } else if (shape.shape == "polygon") {
    draw_corners(dice, shape, a);
    shape.fillet = Dice::rounded(a * dice.between(0.1, 0.15));
  } else {
    const double side = 2 / std::hypot(1, b / a);  // the corners are within a
    shape.measures = {Dice::rounded(side * b), Dice::rounded(side * a)};
    shape.fillet = Dice::rounded(std::min(shape.measures[0], shape.measures[1]) * dice.between(0.25, 0.49));
    shape.area = shape.measures[0] * shape.measures[1];
  }
  shape.radius = shape.shape == "polygon" ? 1.3 * a : 1.001 * a;  // the centre of mass of a polygon is elsewhere
  return shape;
}

void write_shape(CaseText& text, const Shape& shape) {
  text.word("shape", shape.shape);
  if (shape.shape == "circle") text.number("radius", shape.measures[0]);
  if (shape.shape == "ellipse") text.numbers("semi_axes", shape.measures);
  if (shape.shape == "stick" || shape.shape == "rectangle") text.numbers("size", shape.measures);
  if (shape.fillet > 0) text.number("fillet", shape.fillet);
  if (shape.corners.empty()) return;
  std::string corners;
  for (const auto& corner : shape.corners)
    corners += (corners.empty() ? "[" : ", [") + digits(corner[0]) + ", " + digits(corner[1]) + "]";
  text.plain("corners", "[" + corners + "]");
}

std::vector<Place> place_apart(Dice& dice, const Stage& stage, std::vector<Shape>& shapes, double gap) {
  std::vector<Place> places;
  std::vector<Shape> placed;
  for (const Shape& shape : shapes)
    for (int tries = 0; tries < 50; ++tries) {
      Place place;
      const double inset = shape.radius + gap;
      for (std::size_t d = 0; d < 2; ++d) place.position[d] = dice.between(stage.low[d] + inset, stage.high[d] - inset);
      place.angle = dice.chance(0.3) ? 0 : dice.between(-180, 180);
      bool free = stage.high[0] > inset && stage.high[1] > inset;
      for (std::size_t k = 0; k < places.size(); ++k)
        free = free && distance(place.position, places[k].position) > placed[k].radius + inset;
      if (!free) continue;
      places.push_back(place);
      placed.push_back(shape);
      break;
    }
  shapes = placed;
  return places;
}

std::vector<Place> place_close(Dice& dice, const Stage& stage, std::vector<Shape>& shapes) {
  const double h = stage.spacing();
  std::vector<Place> places;
  double end = stage.low[0];
  const bool at_wall = dice.chance(0.4), row = dice.chance(0.5);
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    const bool stick = shapes[k].shape == "stick" || shapes[k].shape == "rectangle";
    const double half = stick ? 0.5 * shapes[k].measures[0] : shapes[k].measures[0];  // along x at angle 0
    const double gap = h * dice.between(3.1, dice.chance(0.6) ? 3.3 : 8);
    Place place;
    place.position[0] = end + gap + half;
    if (k == 0 && !at_wall) place.position[0] = std::max(place.position[0], dice.between(0.4, 0.8) * stage.low[0]);
    place.position[1] = row || k == 0 ? 0.0 : Dice::rounded(shapes[k].radius * dice.between(-0.3, 0.3));
    end = place.position[0] + half;
    if (end + 3.1 * h > stage.high[0]) break;
    places.push_back(place);
  }
  shapes.resize(places.size());
  return places;
}

}  // namespace mortise::random_scenes
