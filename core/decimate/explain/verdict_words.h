#pragma once
// The phrases that explanations of verdicts are made of: names, numbers held against limits,
// sentences.

#include <string>

#include "core/decimate/explain/outlook.h"
#include "core/mesh/model_ref.h"
#include "core/mesh/names.h"

namespace aomd::words {

/// One number, printed with a format of printf.
[[nodiscard]] std::string formatted(const char* format, double value);
/// "10" and "23.4".
[[nodiscard]] std::string degrees(double value);
/// "model edge 3"; "nothing of the model" for what is not classified.
[[nodiscard]] std::string name(ModelRef model);
/// With a capital at its start and a full stop at its end.
[[nodiscard]] std::string sentence(std::string text);

/// A number and its limit, with as many digits as tell them apart.
struct Held {
  std::string value, limit;
};
[[nodiscard]] Held held_degrees(double value, double limit);
[[nodiscard]] Held held_length(double value, double limit);

/// "Face 812 would turn by 23.4 degrees; the limit is 10."
[[nodiscard]] std::string turn_words(EntityRef who, double deg, double limit);
/// "Face 812 would look 63.4 degrees away from the original surface there; the limit is 60."
[[nodiscard]] std::string away_words(EntityRef who, double deg, double limit);
/// A verdict whose reason means the same for every operation; else the help of the reason.
[[nodiscard]] std::string general_words(const Verdict& verdict, const Limits& limits);

/// A model edge that would turn too far from what it was, at a vertex.
[[nodiscard]] std::string curve_words(EntityRef who, double deg, double limit);

}  // namespace aomd::words
