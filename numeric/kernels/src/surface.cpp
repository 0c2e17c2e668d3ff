// SPDX-License-Identifier: 0BSD
#include "twoscale/kernels/surface.hpp"

namespace twoscale::kernels {

std::vector<double> refine_grid(std::span<const double> grid, GridSize size, std::size_t dim, const MaskTable& u_table,
                                DirectionRun u, const MaskTable& v_table, DirectionRun v) {
  return SurfaceRefiner<double>(Refiner<double>(u_table), Refiner<double>(v_table)).refine(grid, size, dim, u, v);
}

}  // namespace twoscale::kernels
