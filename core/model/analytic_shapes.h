#pragma once
// What each analytic shape answers; the analytic model picks the function by the shape.

#include "core/model/analytic_model.h"

namespace aomd::analytic {

/// 0 to 3.
[[nodiscard]] int dimension_of(const AnalyticShape& shape);
/// What is wrong with the numbers of a shape, or nothing.
[[nodiscard]] const char* defect(const AnalyticShape& shape);
/// The nearest point with its parameters; of a region the point itself.
[[nodiscard]] ClosestPoint closest(const AnalyticShape& shape, const glm::dvec3& point);
/// The unit normal of a surface where it is nearest to a point.
[[nodiscard]] glm::dvec3 normal(const AnalyticShape& shape, const glm::dvec3& point);
/// None for points and regions.
[[nodiscard]] std::optional<ParameterRange> range(const AnalyticShape& shape);
[[nodiscard]] glm::dvec3 evaluate(const AnalyticShape& shape, const glm::dvec2& t);
/// The smallest box; empty where the shape is infinite.
[[nodiscard]] Box box(const AnalyticShape& shape);

}  // namespace aomd::analytic
