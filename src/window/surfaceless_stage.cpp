#include "window/surfaceless_stage.h"

#include <GLES2/gl2.h>
#include <algorithm>

#include "window/density.h"
#include "window/rotation.h"

namespace metamer {

SurfacelessStage::SurfacelessStage(int width_px, int height_px, int rotation_deg, double px_per_mm)
    : width_px_(width_px),
      height_px_(height_px),
      rotation_deg_(rotation_deg),
      px_per_mm_(px_per_mm),
      context_(std::in_place),
      target_(std::in_place, width_px, height_px, DepthBuffer::depth16) {}

double SurfacelessStage::px_per_mm() const {
    return diagonal_in_ > 0 ? px_per_mm_of_diagonal(width_px_, height_px_, diagonal_in_) : px_per_mm_;
}

void SurfacelessStage::hang(int rotation_deg, double diagonal_in) {
    rotation_deg_ = rotation_deg;
    diagonal_in_ = diagonal_in;
}

// Both lists keep their memory.
void SurfacelessStage::take_posted() {
    const std::lock_guard lock(mutex_);
    events_.clear();
    events_.swap(posted_);
}

const std::vector<Event>& SurfacelessStage::wait(double most_s) {
    take_posted();
    if (events_.empty() && script_) {
        script_();
        take_posted();
    }
    if (events_.empty())
        now_s_ += std::max(most_s, 0.0);
    return events_;
}

void SurfacelessStage::post(const Event& event) {
    const std::lock_guard lock(mutex_);
    posted_.push_back(event);
}

void SurfacelessStage::bind() {
    target_->bind();
}

void SurfacelessStage::show() {
    // As a swap does: what was drawn is on its way.
    glFlush();
    ++frames_;
}

void SurfacelessStage::lose_context() {
    lost_ = true;
    context_.reset();
    post(ContextLostEvent{});
}

bool SurfacelessStage::rebuild() {
    target_.reset();
    context_.reset();
    if (!display_)
        return false;
    context_.emplace();
    target_.emplace(width_px_, height_px_, DepthBuffer::depth16);
    lost_ = false;
    return true;
}

void SurfacelessStage::resize(int width_px, int height_px) {
    width_px_ = width_px;
    height_px_ = height_px;
    target_.emplace(width_px, height_px, DepthBuffer::depth16);
    const PxSize picture = turned({width_px, height_px}, rotation_deg_);
    post(ResizeEvent{picture.width_px, picture.height_px});
}

std::vector<std::uint8_t> SurfacelessStage::read_rgba() const {
    return target_->read_rgba();
}

} // namespace metamer
