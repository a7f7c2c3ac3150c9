#include "drivers/simulation/physics/physics.hpp"

#include <algorithm>

namespace pizarra::simulation {

namespace {

constexpr double unit_mm = 100;  // one Bullet unit
constexpr double margin_mm = 1;
constexpr double cube_friction = 0.6;
// The solver keeps bodies a hair apart that press on each other.
constexpr double touching_mm = 0.3;

btVector3 to_bullet(const Eigen::Vector3d& mm) { return {mm.x() / unit_mm, mm.y() / unit_mm, mm.z() / unit_mm}; }

Eigen::Vector3d from_bullet(const btVector3& units) {
  return Eigen::Vector3d(units.x(), units.y(), units.z()) * unit_mm;
}

btTransform to_bullet(const Pose& pose) {
  const Eigen::Matrix3d r = pose.linear();
  return btTransform(btMatrix3x3(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2)),
                     to_bullet(Eigen::Vector3d(pose.translation())));
}

Pose from_bullet(const btTransform& transform) {
  Pose pose = Pose::Identity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) pose.linear()(row, column) = transform.getBasis()[row][column];
  }
  pose.translation() = from_bullet(transform.getOrigin());
  return pose;
}

std::unique_ptr<btRigidBody> make_body(double mass_kg, btCollisionShape& shape, double friction) {
  btVector3 inertia(0, 0, 0);
  if (mass_kg > 0) shape.calculateLocalInertia(mass_kg, inertia);
  btRigidBody::btRigidBodyConstructionInfo info(mass_kg, nullptr, &shape, inertia);
  info.m_friction = friction;
  info.m_restitution = 0;
  info.m_linearDamping = 0.04;
  info.m_angularDamping = 0.1;
  info.m_linearSleepingThreshold = 10 / unit_mm;
  info.m_angularSleepingThreshold = 0.1;
  return std::make_unique<btRigidBody>(info);
}

std::unique_ptr<btCollisionShape> collision_shape(const BodyShape& shape) {
  const btVector3 half = to_bullet(Eigen::Vector3d(shape.size_mm / 2));
  std::unique_ptr<btCollisionShape> out;
  if (shape.is_round) {
    out = std::make_unique<btCylinderShapeZ>(half);
  } else {
    out = std::make_unique<btBoxShape>(half);
  }
  out->setMargin(margin_mm / unit_mm);
  return out;
}

// Its own axis that is nearest to the vertical.
Eigen::Index upright_axis(const Pose& pose) {
  Eigen::Index out = 0;
  pose.linear().row(2).cwiseAbs().maxCoeff(&out);
  return out;
}

Eigen::Vector3d table_half(const TableConfig& table) {
  return {(table.x_high_mm - table.x_low_mm) / 2, (table.y_high_mm - table.y_low_mm) / 2, table.thickness_mm / 2};
}

}  // namespace

Physics::Physics(const TableConfig& table)
    : dispatcher_(&configuration_),
      world_(&dispatcher_, &broadphase_, &solver_, &configuration_),
      table_shape_(to_bullet(table_half(table))) {
  gContactBreakingThreshold = 2 / unit_mm;
  world_.setGravity(btVector3(0, 0, -9810 / unit_mm));
  world_.getSolverInfo().m_numIterations = 20;
  world_.getSolverInfo().m_splitImpulse = 1;
  world_.getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
  table_shape_.setMargin(margin_mm / unit_mm);
  table_ = make_body(0, table_shape_, cube_friction);
  Pose place = Pose::Identity();
  place.translation() = Eigen::Vector3d((table.x_low_mm + table.x_high_mm) / 2, (table.y_low_mm + table.y_high_mm) / 2,
                                        -table.thickness_mm / 2);
  table_->setWorldTransform(to_bullet(place));
  world_.addRigidBody(table_.get());
}

Physics::~Physics() {
  let_go();
  for (Dynamic& dynamic : dynamics_) {
    if (dynamic.present) world_.removeRigidBody(dynamic.body.get());
  }
  for (const auto& kinematic : kinematics_) {
    if (kinematic->enabled) world_.removeRigidBody(kinematic->body.get());
  }
  world_.removeRigidBody(table_.get());
}

DynamicId Physics::add_dynamic(const Pose& pose, const BodyShape& shape) {
  std::unique_ptr<btCollisionShape> collision = collision_shape(shape);
  std::unique_ptr<btRigidBody> body = make_body(cube_mass_kg, *collision, cube_friction);
  dynamics_.push_back({shape, std::move(collision), std::move(body), false});
  bring(dynamics_.size() - 1, pose);
  return dynamics_.size() - 1;
}

double Physics::height_mm(DynamicId id) const { return shape(id).size_mm[upright_axis(pose(id))]; }

double Physics::width_mm(DynamicId id) const {
  Eigen::Vector3d across = shape(id).size_mm;
  across[upright_axis(pose(id))] = 0;
  return across.maxCoeff();
}

void Physics::take_away(DynamicId id) {
  if (!dynamics_[id].present) return;
  world_.removeRigidBody(dynamics_[id].body.get());
  dynamics_[id].present = false;
  // What leant on it does not notice by itself.
  for (Dynamic& other : dynamics_) other.body->activate(true);
}

void Physics::bring(DynamicId id, const Pose& pose) {
  btRigidBody& body = *dynamics_[id].body;
  body.setWorldTransform(to_bullet(pose));
  body.setInterpolationWorldTransform(to_bullet(pose));
  if (!dynamics_[id].present) world_.addRigidBody(&body);
  dynamics_[id].present = true;
  set_velocity(id, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
}

Pose Physics::pose(DynamicId id) const { return from_bullet(dynamics_[id].body->getWorldTransform()); }

Eigen::Vector3d Physics::velocity_mm_s(DynamicId id) const {
  return from_bullet(dynamics_[id].body->getLinearVelocity());
}

Eigen::Vector3d Physics::spin_rad_s(DynamicId id) const {
  const btVector3& spin = dynamics_[id].body->getAngularVelocity();
  return {spin.x(), spin.y(), spin.z()};
}

void Physics::set_velocity(DynamicId id, const Eigen::Vector3d& velocity_mm_s, const Eigen::Vector3d& spin_rad_s) {
  btRigidBody& body = *dynamics_[id].body;
  body.activate(true);
  body.setLinearVelocity(to_bullet(velocity_mm_s));
  body.setAngularVelocity(btVector3(spin_rad_s.x(), spin_rad_s.y(), spin_rad_s.z()));
}

KinematicId Physics::add_kinematic(const std::vector<Box>& boxes, double friction) {
  auto kinematic = std::make_unique<Kinematic>();
  auto compound = std::make_unique<btCompoundShape>();
  for (const Box& box : boxes) {
    auto shape = std::make_unique<btBoxShape>(to_bullet(box.half_mm));
    shape->setMargin(margin_mm / unit_mm);
    Pose place = Pose::Identity();
    place.translation() = box.centre_mm;
    compound->addChildShape(to_bullet(place), shape.get());
    kinematic->shapes.push_back(std::move(shape));
  }
  kinematic->body = make_body(0, *compound, friction);
  kinematic->shapes.push_back(std::move(compound));
  kinematic->body->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
  world_.addRigidBody(kinematic->body.get());
  kinematics_.push_back(std::move(kinematic));
  return kinematics_.size() - 1;
}

void Physics::move_kinematic(KinematicId id, const Pose& pose) {
  Kinematic& kinematic = *kinematics_[id];
  btRigidBody& body = *kinematic.body;
  const btTransform target = to_bullet(pose);
  const bool moved = !(body.getWorldTransform() == target);
  body.setWorldTransform(target);
  if (!kinematic.placed) body.setInterpolationWorldTransform(target);
  kinematic.still_steps = moved || !kinematic.placed ? 0 : kinematic.still_steps + 1;
  kinematic.placed = true;
  // Bullet derives its speed from the last two places, so one still step must pass before it may sleep; and a sleeping
  // kinematic body would keep its speed.
  body.forceActivationState(kinematic.still_steps > 1 ? ISLAND_SLEEPING : ACTIVE_TAG);
  if (moved && joint_ && &joint_->getRigidBodyA() == &body) joint_->getRigidBodyB().activate(true);
}

void Physics::enable_kinematic(KinematicId id, bool enabled) {
  Kinematic& kinematic = *kinematics_[id];
  if (kinematic.enabled == enabled) return;
  kinematic.enabled = enabled;
  kinematic.placed = false;
  kinematic.still_steps = 0;
  if (enabled) {
    world_.addRigidBody(kinematic.body.get());
  } else {
    world_.removeRigidBody(kinematic.body.get());
  }
}

Physics::Contact Physics::contact(KinematicId kinematic, DynamicId dynamic) const {
  Contact contact;
  const btCollisionObject* first = kinematics_[kinematic]->body.get();
  const btCollisionObject* second = dynamics_[dynamic].body.get();
  for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
    const btPersistentManifold* manifold = dispatcher_.getManifoldByIndexInternal(i);
    const bool ours = (manifold->getBody0() == first && manifold->getBody1() == second) ||
                      (manifold->getBody0() == second && manifold->getBody1() == first);
    if (!ours) continue;
    for (int point = 0; point < manifold->getNumContacts(); ++point) {
      const double distance_mm = manifold->getContactPoint(point).getDistance() * unit_mm;
      if (distance_mm > touching_mm) continue;
      ++contact.points;
      contact.depth_mm = std::max(contact.depth_mm, -distance_mm);
    }
  }
  return contact;
}

void Physics::set_ignored(KinematicId kinematic, DynamicId dynamic, bool ignored) {
  btRigidBody* body = kinematics_[kinematic]->body.get();
  btRigidBody* other = dynamics_[dynamic].body.get();
  body->setIgnoreCollisionCheck(other, ignored);
  other->setIgnoreCollisionCheck(body, ignored);
  if (!ignored || !dynamics_[dynamic].present) return;
  // The manifold they had would go on acting with its stale points.
  btOverlappingPairCache* pairs = broadphase_.getOverlappingPairCache();
  pairs->cleanProxyFromPairs(other->getBroadphaseHandle(), &dispatcher_);
}

void Physics::hold(KinematicId kinematic, DynamicId dynamic) {
  let_go();
  btRigidBody& body = *kinematics_[kinematic]->body;
  btRigidBody& held = *dynamics_[dynamic].body;
  held.activate(true);
  const btTransform grip = body.getWorldTransform().inverse() * held.getWorldTransform();
  joint_ = std::make_unique<btFixedConstraint>(body, held, grip, btTransform::getIdentity());
  joint_feedback_ = {};
  joint_->setJointFeedback(&joint_feedback_);
  world_.addConstraint(joint_.get());
}

void Physics::let_go() {
  if (!joint_) return;
  joint_->getRigidBodyB().activate(true);
  world_.removeConstraint(joint_.get());
  joint_.reset();
}

double Physics::hold_force_n() const {
  // Bullet's force is kg dm/s2.
  return joint_ ? joint_feedback_.m_appliedForceBodyB.length() * unit_mm / 1000 : 0;
}

void Physics::step() {
  joint_feedback_.m_appliedForceBodyA.setZero();
  joint_feedback_.m_appliedForceBodyB.setZero();
  joint_feedback_.m_appliedTorqueBodyA.setZero();
  joint_feedback_.m_appliedTorqueBodyB.setZero();
  world_.stepSimulation(1.0 / steps_per_second, 0);
}

bool Physics::asleep() const {
  const bool still = std::ranges::all_of(
      kinematics_, [](const auto& kinematic) { return !kinematic->enabled || kinematic->still_steps > 1; });
  return still &&
         std::ranges::none_of(dynamics_, [](const Dynamic& each) { return each.present && each.body->isActive(); });
}

}  // namespace pizarra::simulation
