// SPDX-License-Identifier: MIT
// Jolt: a box on a static box, 10 velocity steps, friction as the geometric mean; its default damping of 0.05 is switched off.
import initJolt from "jolt-physics";
import { halfHeight, halfLength, run } from "./engine.mjs";

const jolt = await initJolt();

run(class {
  constructor(problem, step) {
    this.step = step;
    const settings = new jolt.JoltSettings();
    const pairs = new jolt.ObjectLayerPairFilterTable(2), broad = new jolt.BroadPhaseLayerInterfaceTable(2, 2);
    pairs.EnableCollision(0, 1); // layer 0 stands, layer 1 moves
    [0, 1].forEach((layer) => broad.MapObjectToBroadPhaseLayer(layer, new jolt.BroadPhaseLayer(layer)));
    settings.mObjectLayerPairFilter = pairs;
    settings.mBroadPhaseLayerInterface = broad;
    settings.mObjectVsBroadPhaseLayerFilter = new jolt.ObjectVsBroadPhaseLayerFilterTable(broad, 2, pairs, 2);
    this.world = new jolt.JoltInterface(settings);
    this.world.GetPhysicsSystem().SetGravity(new jolt.Vec3(problem.along, 0, -problem.down));
    this.bodies = this.world.GetPhysicsSystem().GetBodyInterface();
    this.add(problem, [200, 2, 1], [0, 0, -1], jolt.EMotionType_Static, 0);
    this.block = this.add(problem, [halfLength, halfLength, halfHeight], [problem.position, 0, halfHeight], jolt.EMotionType_Dynamic, 1);
    this.block.SetLinearVelocity(new jolt.Vec3(problem.velocity, 0, 0));
  }
  add(problem, half, place, motion, layer) {
    const settings = new jolt.BodyCreationSettings(new jolt.BoxShape(new jolt.Vec3(...half)), new jolt.RVec3(...place),
      new jolt.Quat(0, 0, 0, 1), motion, layer);
    settings.mFriction = problem.friction;
    settings.mLinearDamping = settings.mAngularDamping = 0;
    settings.mOverrideMassProperties = jolt.EOverrideMassProperties_CalculateInertia;
    settings.mMassPropertiesOverride.mMass = problem.mass;
    const body = this.bodies.CreateBody(settings);
    this.bodies.AddBody(body.GetID(), jolt.EActivation_Activate);
    return body;
  }
  push(force) { this.bodies.AddForce(this.block.GetID(), new jolt.Vec3(force, 0, 0), jolt.EActivation_Activate); }
  advance() { this.world.Step(this.step, 1); }
  position() { return this.block.GetPosition().GetX(); }
  velocity() { return this.block.GetLinearVelocity().GetX(); }
}, 1 / 60);
