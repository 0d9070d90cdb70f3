// A fibre network as an elastic model: springs, beams, tethers, in this order, are its elements, springs what is drawn. With
// a time for it (key structure.fold_relaxation_s), sharp folds flatten by slip (fold_relaxation.hpp).
#pragma once

#include "ib3d/structure/elastic_model.hpp"
#include "ib3d/structure/fibres/fibre_network.hpp"

namespace valsalva::ib3d {

class FibreModel final : public ElasticModel {
 public:
  /// `fold_relaxation` in s; 0: folds are left alone.
  explicit FibreModel(FibreNetwork network, double fold_relaxation = 0)
      : network_(std::move(network)), fold_relaxation_(fold_relaxation)
  {
  }
  const FibreNetwork& network() const { return network_; }

  const std::vector<Vec3>& start() const override { return network_.X; }
  const std::vector<NodeGroup>& groups() const override { return network_.groups; }
  void add_force(std::span<const Vec3> X, std::span<Vec3> F) const override;
  double energy(std::span<const Vec3> X) const override;
  void add_stiffness_times(std::span<const Vec3> X, std::span<const Vec3> v,
                           std::span<Vec3> Kv) const override;
  void add_slip(std::span<const Vec3> X, double dt, std::span<Vec3> U) const override;
  Elements elements() const override;
  std::unique_ptr<const ElasticModel> part(const Selection& selection) const override;
  Deformation deformation(std::span<const Vec3> X) const override;
  StrainedElements drawing(std::span<const Vec3> X) const override;

 private:
  FibreNetwork network_;
  double fold_relaxation_;
};

}  // namespace valsalva::ib3d
