"""What the guard does: stand, walk, look, run, reach, in place, without root motion.

Feet are solved, not drawn: while a boot is down it travels backwards at exactly the speed at which the game moves
the guard forwards, so nothing slides.

  walk   1.4 m/s   cycle of 32 frames, 1.0667 s, 1.493 m for two steps
  run    4.2 m/s   cycle of 21 frames, 0.7000 s, 2.940 m for two steps
  stand  3 s, look 4 s: loops;  reach 1 s: played once, its last frame is held

Every loop's last frame is its first one again.
"""
import bpy
import numpy as np
from mathutils import Matrix

from guard_bones import REST, Pose, turn
from guard_shapes import interpolate, smoothstep

FRAMES_PER_SECOND = 30
WALK_FRAMES, WALK_SPEED = 32, 1.4
RUN_FRAMES, RUN_SPEED = 21, 4.2
TAU = 2 * np.pi

TORCH = REST["torch"][2] - REST["torch"][1]
TORCH = TORCH / np.linalg.norm(TORCH)
ANKLE = REST["foot.R"][1]
BALL = np.array((0, .125, .012))   # what the foot rolls over, at rest
HEEL = np.array((0, -.080, .012))


def side_of(bone_side):
    return 1.0 if bone_side == ".R" else -1.0


def foot_down(pose, side, shift, pitch_deg, across, spread_deg=5.0):
    """Puts a boot with its sole's frame shifted by `shift`, heel down for positive pitch, toes for negative."""
    sign = side_of(side)
    pivot = HEEL if pitch_deg > 0 else BALL
    x = sign * across
    foot = turn("x", pitch_deg)
    ankle = pivot + foot @ (np.array((0, ANKLE[1], ANKLE[2])) - pivot)
    target = np.array((x, 0, 0)) + ankle + np.asarray(shift, dtype=float)
    hint = np.array((sign * .08, 1.0, 0)) if pose.world["hips"][1, 1] > .2 else pose.world["hips"][:, 1]
    pose.reach("thigh" + side, "shin" + side, "foot" + side, target, hint)
    out = turn("z", -sign * spread_deg)
    pose.set("foot" + side, out @ foot)
    pose.set("toe" + side, out @ turn("x", max(pitch_deg, min(0.0, pitch_deg + 58))) if pitch_deg < 0 else out @ foot)


def arm(pose, side, wrist, elbow, roll_deg=0.0, hand_turn=None):
    """Wrist target and elbow hint in the chest's frame (x outwards, y forwards, z up from the shoulder)."""
    sign = side_of(side)
    flip = np.array((sign, 1.0, 1.0))
    chest = pose.world["chest"]
    pose.place("upper_arm" + side)
    target = pose.joint["upper_arm" + side] + chest @ (np.asarray(wrist, dtype=float) * flip)
    pose.reach("upper_arm" + side, "forearm" + side, "hand" + side, target, chest @ (np.asarray(elbow) * flip))
    rest = REST["hand" + side][1] - REST["forearm" + side][1]
    along = pose.world["forearm" + side] @ (rest / np.linalg.norm(rest))
    twisted = about(along, sign * roll_deg)
    pose.set("forearm" + side, about(along, sign * roll_deg * .45) @ pose.world["forearm" + side])
    pose.set("hand" + side, about(along, sign * roll_deg * .55) @ pose.world["forearm" + side])
    if hand_turn is not None:
        pose.set("hand" + side, chest @ hand_turn @ chest.T @ pose.world["hand" + side])
    return twisted


def about(axis, angle_deg):
    a = np.radians(angle_deg)
    x, y, z = axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(a) * cross + (1 - np.cos(a)) * (cross @ cross)


def trunk(pose, pitch=0, yaw=0, roll=0, head_pitch=0, head_yaw=0, breath=0):
    """Spreads a lean over spine and chest, lifts the shoulders with the breath, and keeps the head level."""
    part = turn("z", yaw / 2) @ turn("y", roll / 2) @ turn("x", pitch / 2)
    pose.bend("spine", part)
    pose.bend("chest", part @ turn("x", -breath))
    for side in (".R", ".L"):
        pose.bend("clavicle" + side, turn("y", -side_of(side) * 1.6 * breath))
    level = turn("z", head_yaw) @ turn("x", head_pitch)
    pose.bend("neck", blend_turn(pose.world["chest"].T @ level))
    pose.set("head", level)


def blend_turn(matrix):
    """Half of a turn."""
    half = Matrix(matrix.tolist()).to_quaternion()
    half = Matrix.Identity(3).to_quaternion().slerp(half, 0.5)
    return np.array(half.to_matrix())


def carry_torch(pose, swing=0.0, raise_=0.0, inward=0.0):
    """The right arm: elbow a little bent, torch pointing forwards at the hip."""
    arm(pose, ".R", (.065 - inward, .115 + .10 * swing + .10 * raise_, -.485 + .05 * abs(swing) + .12 * raise_),
        (.35, -1.0, -.1), -8)
    aim_torch(pose, (-.04, 1.0, -.10 + .1 * raise_))


def aim_torch(pose, wanted, most_deg=38.0):
    """Turns the wrist so that the torch points along `wanted` in the chest's frame, as far as a wrist can."""
    now = pose.world["hand.R"] @ TORCH
    wanted = pose.world["chest"] @ (np.asarray(wanted, dtype=float) / np.linalg.norm(wanted))
    axis = np.cross(now, wanted)
    angle = min(most_deg, np.degrees(np.arccos(np.clip(np.dot(now, wanted), -1, 1))))
    pose.set("hand.R", about(axis / max(np.linalg.norm(axis), 1e-9), angle) @ pose.world["hand.R"])


def stand(t):
    breath = .5 - .5 * np.cos(TAU * t)
    sway = np.sin(TAU * t)
    pose = Pose((.012 * sway, -.006, -.014 - .003 * breath), turn("y", .8 * sway))
    trunk(pose, -1.0, 0, -.8 * sway, 1.0, 2 * sway, breath * 1.3)
    for side in (".R", ".L"):
        foot_down(pose, side, (0, .03 if side == ".L" else -.015, 0), 0, .125, 9)
    carry_torch(pose, .05 * breath)
    arm(pose, ".L", (.075, .045, -.510 + .006 * breath), (.35, -1, 0), 6)
    pose.bend("fingers.L", turn("x", 0))
    return pose


def gait(pose, phase, speed, cycle_s, duty, reach_front, lift, across, toe_off_deg, strike_deg):
    """Both legs of a walk or run at `phase` of the cycle; the right boot strikes at 0, the left half later."""
    for side, offset in ((".R", 0.0), (".L", 0.5)):
        p = (phase + offset) % 1.0
        travel = speed * cycle_s
        if p < duty:
            y = reach_front - travel * p
            u = p / duty
            pitch = interpolate([(0, strike_deg), (.17, 0), (.52, 0), (.8, -toe_off_deg * .45), (1, -toe_off_deg)], u)
            foot_down(pose, side, (0, y, 0), float(pitch), across)
            continue
        u = (p - duty) / (1 - duty)
        back = reach_front - travel * duty
        # The swing starts and ends with the ground's speed, so that the boot neither stamps nor skids.
        slope = -travel * (1 - duty)
        h00, h10 = 2 * u**3 - 3 * u**2 + 1, u**3 - 2 * u**2 + u
        h01, h11 = 3 * u**2 - 2 * u**3, u**3 - u**2
        y = h00 * back + h10 * slope * .55 + h01 * reach_front + h11 * slope * .55
        z = float(interpolate(lift, u))
        pitch = float(interpolate([(0, -toe_off_deg), (.22, -toe_off_deg * 1.05), (.62, -4), (.85, strike_deg * 1.1),
                                   (1, strike_deg)], u))
        foot_down(pose, side, (0, y, z), pitch, across)


def walk(t):
    a = TAU * t
    # Lowest in double support (t = 0, 1/2), highest over the standing leg.
    height = -.037 - .016 * np.cos(2 * a)
    lateral = .018 * np.sin(a)
    pose = Pose((lateral, -.005, height), turn("z", 5.5 * np.cos(a)) @ turn("y", -2.2 * np.sin(a)))
    trunk(pose, -2.5, -9.5 * np.cos(a), 2.0 * np.sin(a), 0, -1.5 * np.cos(a), .3)
    gait(pose, t, WALK_SPEED, WALK_FRAMES / FRAMES_PER_SECOND, .60, .385,
         [(0, 0), (.3, .050), (.62, .028), (.85, .022), (1, 0)], .088, 48, 20)
    carry_torch(pose, -.55 * np.cos(a) - .1)
    swing = np.cos(a)
    arm(pose, ".L", (.070, .065 + .195 * swing, -.500 + .035 * swing**2 + .02 * swing), (.25, -1, 0), 6)
    return pose


def run(t):
    a = TAU * t
    # One flight after each push-off: lowest in the middle of each stance.
    height = -.066 - .034 * np.cos(2 * (a - TAU * .155))
    pose = Pose((.010 * np.sin(a), .02, height), turn("z", 9 * np.cos(a)) @ turn("x", -5) @ turn("y", -3 * np.sin(a)))
    trunk(pose, -10, -20 * np.cos(a), 2 * np.sin(a), -2, 0, .6)
    gait(pose, t, RUN_SPEED, RUN_FRAMES / FRAMES_PER_SECOND, .31, .36,
         [(0, 0), (.18, .16), (.40, .34), (.66, .26), (.86, .09), (1, 0)], .07, 56, 8)
    for side, swing in ((".R", -np.cos(a)), (".L", np.cos(a))):
        forward = .5 + .5 * swing
        arm(pose, side, (.05 - .09 * forward, -.08 + .36 * forward, -.345 + .17 * forward), (.45, -1, -.25), 4)
    return pose


def look(t):
    yaw = float(interpolate([(0, 0), (.22, 1), (.38, 1), (.64, -1), (.80, -1), (1, 0)], t))
    breath = .5 - .5 * np.cos(TAU * 2 * t)
    pose = Pose((.015 * -yaw, -.004, -.018), turn("z", 9 * yaw))
    trunk(pose, -3, 26 * yaw, 0, -3 + 2 * np.cos(TAU * 2 * t), 66 * yaw, breath)
    for side in (".R", ".L"):
        foot_down(pose, side, (0, .03 if side == ".L" else -.015, 0), 0, .125, 9)
    carry_torch(pose, .2, 1.15, .03)
    arm(pose, ".L", (.085, .040, -.505), (.35, -1, 0), 6)
    return pose


def reach(t):
    go = float(smoothstep(0.0, .62, t))
    ready = float(interpolate([(0, 0), (.22, 1), (.5, .2), (1, 0)], t))
    pose = Pose((0, -.03 * ready + .13 * go, -.014 - .055 * go - .02 * ready), turn("z", -14 * go) @ turn("x", -7 * go))
    trunk(pose, -2 + 5 * ready - 16 * go, -16 * go, 0, -4 * go, 0, .4)
    foot_down(pose, ".R", (0, -.015 - .165 * go, 0), -30 * go, .125, 9)
    foot_down(pose, ".L", (0, .03 + .30 * go, .05 * np.sin(np.pi * min(1.0, go))), 0, .115, 6)
    carry_torch(pose, -.8 * go, 0)
    wrist = np.array((.075, .045, -.510)) * (1 - go) + np.array((-.03, .500, .130)) * go
    wrist += np.array((.0, -.06, .05)) * ready * (1 - go) + np.array((.05, .10, 0)) * np.sin(np.pi * go)
    arm(pose, ".L", wrist, (.6, -.6, -.5), 6 + 30 * go)
    return pose


CLIPS = {"stand": (stand, 90), "walk": (walk, WALK_FRAMES), "look": (look, 120), "run": (run, RUN_FRAMES),
         "reach": (reach, 30)}


def add_clips(armature):
    """One action and one NLA track a clip; the armature itself is left in its rest pose."""
    armature.animation_data_create()
    rest = {bone.name: np.array(bone.matrix_local.to_3x3()) for bone in armature.data.bones}
    for name, (pose_at, frames) in CLIPS.items():
        action = bpy.data.actions.new(name)
        action.id_root = "OBJECT"
        write_keys(action, rest, pose_at, frames)
        track = armature.animation_data.nla_tracks.new()
        track.name = name
        track.strips.new(name, 0, action)
        track.mute = True
    armature.animation_data.action = None


def write_keys(action, rest, pose_at, frames):
    previous = {}
    curves = {}
    for frame in range(frames + 1):
        at = 0.0 if frame == frames and pose_at is not reach else frame / frames
        pose = pose_at(at)
        for bone, local in pose.local_turns().items():
            basis = rest[bone].T @ local @ rest[bone]
            quaternion = Matrix(basis.tolist()).to_quaternion()
            if bone in previous and quaternion.dot(previous[bone]) < 0:
                quaternion.negate()
            previous[bone] = quaternion
            curves.setdefault((bone, "rotation_quaternion"), []).append(tuple(quaternion))
        curves.setdefault(("hips", "location"), []).append(tuple(rest["hips"].T @ pose.shift))
    for (bone, channel), values in curves.items():
        for component in range(len(values[0])):
            curve = action.fcurves.new(f'pose.bones["{bone}"].{channel}', index=component, action_group=bone)
            curve.keyframe_points.add(len(values))
            flat = [x for frame, value in enumerate(values) for x in (frame, value[component])]
            curve.keyframe_points.foreach_set("co", flat)
            for point in curve.keyframe_points:
                point.interpolation = "LINEAR"
            curve.update()
