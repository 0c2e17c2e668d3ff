// SPDX-License-Identifier: 0BSD
// One step of double or float rows: whole groups by vector instructions, what is left over row by row.
#include "step_groups.hpp"
#include "twoscale/kernels/refine.hpp"

namespace twoscale::kernels::detail {

template <class Real>
VectorStep<Real>::VectorStep(const Mask<Real>& mask) : arity_(mask.arity), begin_{0} {
  for (long r = 0; r < arity_; ++r) {
    for (long s = floor_div(mask.highest() - r, arity_); arity_ * s + r >= mask.lowest; --s) {  // j = q - s upwards
      const Real weight = mask.a[static_cast<std::size_t>(arity_ * s + r - mask.lowest)];
      if (weight == Real(0)) continue;
      weight_.push_back(weight);
      offset_.push_back(-s);
    }
    begin_.push_back(weight_.size());
  }
}

template <class Real>
bool VectorStep<Real>::can_stream(std::size_t width, std::size_t in_stride, std::size_t out_stride) const {
  return direct_stream(static_cast<std::size_t>(arity_), width, in_stride, out_stride);
}

template <class Real>
void VectorStep<Real>::operator()(const Rows<Real>& rows) const {
  const long m = arity_;
  const std::ptrdiff_t stride = static_cast<std::ptrdiff_t>(rows.in_stride);
  Real* out = rows.out;
  const auto single = [&](long i) {
    const long q = floor_div(i, m);
    const std::size_t r = static_cast<std::size_t>(i - m * q);
    const Real* in = rows.in + (q - rows.in_first) * stride;
    for (std::size_t c = 0; c < rows.width; ++c) {
      Real sum = 0;
      for (std::size_t s = begin_[r]; s < begin_[r + 1]; ++s) {
        const Real term = weight_[s] * in[offset_[s] * stride + static_cast<std::ptrdiff_t>(c)];
        sum = s == begin_[r] ? term : sum + term;
      }
      out[c] = sum;
    }
    out += rows.out_stride;
  };
  const long end = rows.out_first + static_cast<long>(rows.count);
  const long q_first = ceil_div(rows.out_first, m);
  const long q_end = std::max(q_first, floor_div(end, m));
  long i = rows.out_first;
  for (; i < std::min(end, m * q_first); ++i) single(i);
  if (q_end > q_first) {
    const std::size_t groups = static_cast<std::size_t>(q_end - q_first);
    run_groups({weight_.data(), offset_.data(), begin_.data(), static_cast<std::size_t>(m), groups, rows.width,
                rows.in + (q_first - rows.in_first) * stride, rows.in_stride, out, rows.out_stride, rows.stream});
    out += groups * static_cast<std::size_t>(m) * rows.out_stride;
    i = m * q_end;
  }
  for (; i < end; ++i) single(i);
}

template <class Real>
void VectorStep<Real>::whole_groups(const Real* in, std::size_t groups, std::size_t width, Real* out,
                                    bool stream) const {
  run_groups({weight_.data(), offset_.data(), begin_.data(), static_cast<std::size_t>(arity_), groups, width, in, width,
              out, width, stream});
}

template <class Real>
void VectorStep<Real>::groups_apart(const Real* in, std::size_t groups, std::size_t width, std::size_t segments,
                                    Real* const* out) const {
  if constexpr (std::is_same_v<Real, double>) {
    run_groups_apart(
        {weight_.data(), offset_.data(), begin_.data(), 2, groups, width, in, width * segments, nullptr, 0, false},
        out);
  }
}

template <>
std::size_t segments_of<double>(std::size_t width) {
  return best_segments(width);
}
template <>
std::size_t segments_of<float>(std::size_t) {
  return 0;
}

template class VectorStep<double>;
template class VectorStep<float>;

}  // namespace twoscale::kernels::detail
