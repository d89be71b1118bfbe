#include "core/decimate/explain/verdict_words.h"

#include <array>
#include <cstdio>

#include "core/base/text.h"
#include "core/decimate/explain/explanation.h"
#include "core/model/model.h"

namespace aomd::words {

std::string formatted(const char* format, double value) {
  std::array<char, 40> buffer;
  std::snprintf(buffer.data(), buffer.size(), format, value);
  return buffer.data();
}

std::string degrees(double value) {
  std::string text = formatted("%.1f", value);
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text;
}

Held held_degrees(double value, double limit) {
  Held held{degrees(value), degrees(limit)};
  if (held.value == held.limit && value != limit) held.value = formatted("%.4f", value);
  return held;
}

Held held_length(double value, double limit) {
  Held held{number_text(value, 3), number_text(limit, 3)};
  if (held.value == held.limit) held = {number_text(value), number_text(limit)};
  return held;
}

std::string name(ModelRef model) { return model.valid() ? name_of(model) : "nothing of the model"; }

std::string sentence(std::string text) { return capitalized(std::move(text)) + "."; }

std::string turn_words(EntityRef who, double deg, double limit) {
  const Held held = held_degrees(deg, limit);
  return sentence(name_of(who) + " would turn by " + held.value + " degrees; the limit is " +
                  held.limit);
}

std::string away_words(EntityRef who, double deg, double limit) {
  const Held held = held_degrees(deg, limit);
  return sentence(name_of(who) + " would look " + held.value +
                  " degrees away from the original surface there; the limit is " + held.limit);
}

std::string curve_words(EntityRef who, double deg, double limit) {
  const Held held = held_degrees(deg, limit);
  return sentence("the model edge would turn by " + held.value + " degrees from the original at " +
                  name_of(who) + "; the limit is " + held.limit);
}

namespace {

std::string distance_words(const Verdict& verdict, double limit) {
  if (verdict.number() <= limit)
    return sentence(name_of(verdict.entity) + " cannot be shown to stay within " +
                    number_text(limit, 3) + " of the original");
  const Held held = held_length(verdict.number(), limit);
  return sentence("at " + name_of(verdict.entity) + " the surface would leave the original by " +
                  held.value + "; the limit is " + held.limit);
}

}  // namespace

std::string general_words(const Verdict& verdict, const Limits& limits) {
  const EntityRef who = verdict.entity;
  switch (verdict.reason) {
    case Reason::Flat:
      return sentence(name_of(who) + " would have no area");
    case Reason::Angle:
      if (who.dimension == 0) return curve_words(who, verdict.number(), limits.curve_sum_deg);
      // One number for both: what is within one limit was refused by the other.
      if (limits.away_deg > 0 && verdict.number() <= limits.turn_deg)
        return away_words(who, verdict.number(), limits.away_deg);
      return turn_words(who, verdict.number(), limits.turn_deg);
    case Reason::Kept:
      return sentence(name_of(who) + " is to stay where it is");
    case Reason::Shape: {
      const Held held = held_degrees(verdict.number(), limits.min_angle_deg);
      return sentence(name_of(who) + " would get an angle of " + held.value +
                      " degrees; the least is " + held.limit);
    }
    case Reason::Distance:
      return distance_words(verdict, limits.distance);
    case Reason::Intersection:
      return sentence("the surface would cut itself at " + name_of(who));
    default:
      return reason_words(verdict.reason).help;
  }
}

}  // namespace aomd::words
