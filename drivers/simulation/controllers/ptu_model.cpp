#include "drivers/simulation/controllers/ptu_model.hpp"

#include <algorithm>

namespace pizarra::simulation {

namespace {

constexpr PtuModel models[] = {
    {"ptu46-17.5", {185.1428, -3090, 3090, 5833}, {185.1428, -907, 604, 5833}, {1000, 5833, 57, 57, 2000}},
    {"ptu46-70", {46.2857, -12404, 12403, 4666}, {46.2857, -3628, 2416, 4666}, {1000, 4666, 57, 57, 2000}},
};

}  // namespace

std::span<const PtuModel> ptu_models() { return models; }

const PtuModel* find_ptu_model(std::string_view name) {
  const auto* found = std::ranges::find(models, name, &PtuModel::name);
  return found == std::end(models) ? nullptr : found;
}

}  // namespace pizarra::simulation
