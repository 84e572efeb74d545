# SPDX-License-Identifier: MIT
"""A scene to look at and to ask the way in."""
import warnings

from bulletnav import _core, arrays, given


class Scene:
    """A mesh file, ready to be drawn from anywhere and walked in.

    Frame: metres, y up; yaw in radians about +y, 0 looks along -z, positive turns left.
    Arguments by name: import_={"up": "y" | "z", "scale", "ground_plane", "doors": "as_built" |
    "open" | "closed" | {"open_share", "seed"}, "finish": {...}},
    navmesh={...}, backend="auto" | "egl" | "embree". Raises FileError for what is no scene;
    warns of what is drawn grey.
    """

    def __init__(self, file, **options):
        self.file = given.path(file, "scene: a scene is a file's name")
        self._scene = _core.Scene(self.file, given.config(options, "scene"))
        grey = self._scene.grey()
        if grey:
            warnings.warn(grey, stacklevel=2)

    def render(self, poses, camera=None):
        """Pictures at `poses`: the eye's [x, y, z, yaw], one or a list of n.

        `camera`: {"type": "panorama", "rows", "cols", "projection", "max_depth_m"} (the default,
        128 x 512) or {"type": "pinhole", "hfov_deg", "rows", "cols", "pitch_deg", "max_depth_m"}.
        Returns {"color": uint8 [n, rows, cols, 3] RGB, "depth": float32 [n, rows, cols] metres
        along the ray, 0: nothing there}; without n for one pose. Arrays of their own.
        """
        if camera is not None and not isinstance(camera, dict):
            raise _core.Error("bulletnav scene: a camera is a dict, as {'type': 'pinhole', "
                              f"'hfov_deg': 79}}, not {camera!r}")
        settings = dict(camera or {})
        kind = str(settings.pop("type", "panorama"))
        rule = "scene: a pose is [x, y, z, yaw]: the eye in metres, radians"
        if hasattr(poses, "__iter__"):
            poses = poses.tolist() if hasattr(poses, "tolist") else list(poses)
            is_one = not all(hasattr(row, "__len__") for row in poses)
        else:
            is_one = True
        rows = [given.numbers(row, 4, rule) for row in ([poses] if is_one else poses)]
        color, depth = self._scene.render(rows, kind, given.config(settings, "camera"))
        if is_one:
            color, depth = color[0], depth[0]
        return {"color": arrays.view(color), "depth": arrays.view(depth)}

    def snap(self, point):
        """The nearest point (x, y, z) of the walkable floor, within 2 m sideways and 4 m up or
        down; None if there is none."""
        found = self._scene.snap(given.point(point, "scene.snap"))
        return None if found is None else tuple(found)

    def path(self, start, end):
        """(metres, [(x, y, z), ...]): the shortest walk between the floor near two points; None
        between islands."""
        found = self._scene.path(given.point(start, "scene.path"),
                                 given.point(end, "scene.path"))
        return None if found is None else (found[0], [tuple(point) for point in found[1]])

    def distance(self, start, end):
        """Metres of the shortest walk; infinite where there is none."""
        return self._scene.distance(given.point(start, "scene.distance"),
                                    given.point(end, "scene.distance"))

    def island(self, point):
        """Number of the island of the floor near `point`; None if there is no floor."""
        return self._scene.island(given.point(point, "scene.island"))

    def random_points(self, count, seed=0, island=0):
        """Points (x, y, z) drawn evenly from an island's area, -1: from all. The same
        for the same seed."""
        count = given.whole(count, "scene.random_points: count is a whole number")
        seed = given.seed(seed, "scene.random_points")
        island = given.whole(island, "scene.random_points: an island is a number, -1: any", -1)
        return [tuple(point) for point in self._scene.random_points(count, seed, island)]

    @property
    def islands(self):
        """Connected parts of the floor, largest first: [{"area": m2, "radius": m}]."""
        return self._scene.islands()

    @property
    def objects(self):
        """What the numbers of a camera's channel "semantic" stand for: [{"category", "name",
        "room"}], the first for what is not known; empty for scenes that do not say."""
        return self._scene.objects()

    @property
    def doors(self):
        """Doors that can be turned, as they stand: [{"object": its name, "hinge": a point of the
        hinge [x, y, z], "axis": about which it opens, "width": metres, "angle": radians, 0 where it
        is shut, "is_open", "leads_outside"}]; empty unless import_["doors"] is given."""
        return self._scene.doors()

    @property
    def report(self):
        """What was imported: {"triangles", "materials", "textures", "textures_missing": names with
        reasons, "extent": metres, "skipped": lines}."""
        return self._scene.report()

    @property
    def renderer(self):
        """What draws: "Embree 3, AVX-512" or the name of a graphics processor."""
        return self._scene.renderer()
