# SPDX-License-Identifier: MIT
"""Spheres that move: the program's own bits, closed forms, wrong arguments."""

import math
import pathlib
import tempfile
import unittest

import numpy as np
from support import CONTEXTS, Case, spherepair

RANDOM = np.random.default_rng(2)
POSITIONS = RANDOM.uniform(1, 5, (40, 3))
VELOCITIES = RANDOM.uniform(-1, 1, (40, 3))
RADII = RANDOM.uniform(0.1, 0.2, 40)


def simulation(backend="cpu", **options):
    return spherepair.Simulation(POSITIONS, RADII, VELOCITIES, backend=backend, **options)


class Simulations(Case):
    def test_every_backend_has_the_same_bits(self):
        for contact in ("none", "spring", "hertz", "quartic"):
            expected = simulation(contact=contact)
            expected.move(200)
            for name in CONTEXTS:
                with self.subTest(contact=contact, backend=name), simulation(name, contact=contact) as other:
                    other.move(200)
                    self.assertEqual(expected.dt, other.dt)
                    np.testing.assert_array_equal(expected.positions, other.positions)
                    np.testing.assert_array_equal(expected.velocities, other.velocities)
                    np.testing.assert_array_equal(expected.pairs(), other.pairs())

    def test_a_ball_falls_and_bounces(self):
        ball = spherepair.Simulation([[0, 5.5, 0]], 0.5, gravity=8, restitution=0.5, dt=1 / 64, backend="cpu")
        ball.move(64)
        self.assertEqual((64, 1.0), (ball.steps, ball.time))
        self.assertAlmostEqual(1.5, float(ball.positions[0, 1]), places=5)
        self.assertAlmostEqual(-8, float(ball.velocities[0, 1]), places=5)
        ball.move(64)
        since = 2 - math.sqrt(10 / 8)
        up = 0.5 * 8 * math.sqrt(10 / 8)
        self.assertAlmostEqual(0.5 + up * since - 4 * since**2, float(ball.positions[0, 1]), places=4)

    def test_contacts_keep_the_momentum(self):
        gas = simulation(contact="hertz", gravity=0, plane=-100)
        mass = RADII[:, None]**3
        before = gas.velocities.astype(float)
        gas.move(5000)
        after = gas.velocities.astype(float)
        self.assertGreater(np.count_nonzero((before != after).any(1)), 1)
        np.testing.assert_allclose((mass * before).sum(0), (mass * after).sum(0), atol=1e-6 * mass.sum())

    def test_walls_hold_spheres(self):
        gas = simulation(contact="spring", restitution=0.5, walls=((0, 0, 0), (6, 6, 6)))
        gas.move(20000)
        self.assertTrue((gas.positions > 0).all() and (gas.positions < 6).all())

    def test_periodic_boxes_hold_spheres_without_walls(self):
        box = dict(contact="spring", gravity=0.0, walls=((0, 0, 0), (6, 6, 6)), pbc=True)
        gas = simulation(**box)
        gas.move(20000)
        self.assertTrue((gas.positions >= 0).all() and (gas.positions <= 6).all())
        np.testing.assert_array_equal(spherepair.collisions(gas.positions, RADII.astype("f4"), (6, 6, 6), True), gas.pairs())
        for name in CONTEXTS:
            with self.subTest(backend=name), simulation(name, **box) as other:
                other.move(20000)
                np.testing.assert_array_equal(gas.positions, other.positions)

    def test_the_state_is_a_new_array_each_time(self):
        moving = simulation()
        before, again = moving.positions, moving.positions
        self.assertIsNot(before, again)
        np.testing.assert_array_equal(POSITIONS.astype(np.float32), before)
        self.assertEqual(((40, 3), np.float32), (before.shape, before.dtype))
        moving.move()
        self.assertFalse((before == moving.positions).all())
        moving.close()
        np.testing.assert_array_equal(before, again)

    def test_pairs_are_those_of_collisions(self):
        dense = spherepair.Simulation(POSITIONS, 0.8, plane=-1, backend="cpu")
        expected = spherepair.collisions(POSITIONS.astype(np.float32), np.float32(0.8), backend="cpu")
        self.assertGreater(len(expected), 50)
        np.testing.assert_array_equal(expected, dense.pairs())

    def test_checkpoints_continue_on_every_backend(self):
        with tempfile.TemporaryDirectory() as folder:
            for contact in ("none", "spring"):
                expected = simulation(contact=contact)
                expected.move(70)
                file = pathlib.Path(folder) / contact
                expected.save(file)
                saved = expected.checkpoint()
                self.assertEqual(file.read_bytes(), saved)
                expected.move(50)
                for name in CONTEXTS:
                    for given in (file, str(file), saved, bytearray(saved), np.frombuffer(saved, np.uint8)):
                        with spherepair.Simulation.resume(given, backend=name) as resumed:
                            self.assertEqual((70, expected.dt), (resumed.steps, resumed.dt))
                            resumed.move(50)
                            np.testing.assert_array_equal(expected.positions, resumed.positions)
                            self.assertEqual(expected.checkpoint(), resumed.checkpoint())

    def test_wrong_checkpoints(self):
        moving = simulation()
        saved = moving.checkpoint()
        for given, says in ((saved[:-1], "cut off"), (b"", "the checkpoint, byte 0"), ("none", "cannot read none"), (7, "type int"),
                            ("a\0b", "null character"), (saved[:100] + b"?" + saved[101:], "damaged")):
            with self.subTest(says), self.assertRaisesRegex(ValueError, says):
                spherepair.Simulation.resume(given, backend="cpu")
        with self.assertRaisesRegex(ValueError, "cannot write /none/file"):
            moving.save("/none/file")
        with self.assertRaisesRegex(ValueError, "null character"):
            moving.save("a\0b")
        with self.assertRaises(ValueError):
            spherepair.Simulation.resume(saved, backend="abacus")

    def test_images_are_the_same_on_every_backend(self):
        views = (dict(), dict(light=False, color="speed"), dict(eye=(9, 4, 12), target=[3, 3, 3], color="radius", color_range=(0.1, 0.3)),
                 dict(up=np.array([0, 0, 1]), azimuth=200, elevation=20.0, field=40, nearest=1, ground=False))
        expected = simulation(contact="spring")
        expected.move(20)
        images = [expected.draw(80, 60, samples=2, **view) for view in views]
        self.assertEqual([((60, 80, 4), np.uint8)] * 4, [(image.shape, image.dtype) for image in images])
        for image in images:
            self.assertTrue((image[..., 3] == 255).all())
            self.assertGreater(np.count_nonzero((image[..., :3] != 255).any(2)), 100)
        for name in CONTEXTS:
            with simulation(name, contact="spring") as other:
                other.move(20)
                for image, view in zip(images, views):
                    with self.subTest(backend=name, view=view):
                        np.testing.assert_array_equal(image, other.draw(80, 60, samples=2, **view))

    def test_images_go_into_the_callers_array(self):
        moving = simulation()
        image = moving.draw(80, 60, samples=1)
        whole = np.full((70, 90, 4), 7, np.uint8)
        inside = whole[5:65, 4:84]
        self.assertIs(inside, moving.draw(samples=1, out=inside))
        np.testing.assert_array_equal(image, inside)
        inside[:] = 7
        self.assertTrue((whole == 7).all())
        upside_down = whole[64:4:-1, 4:84]
        moving.draw(80, 60, samples=1, out=upside_down)
        np.testing.assert_array_equal(image, upside_down)
        self.assertEqual((720, 1280, 4), moving.draw(samples=1).shape)

    def test_wrong_drawings(self):
        moving = simulation()
        read_only = np.zeros((60, 80, 4), np.uint8)
        read_only.flags.writeable = False
        for options, says in ((dict(width=0), "an image of 0 x 60"), (dict(height=20000), "80 x 20000"), (dict(samples=0), "samples is 0"),
                              (dict(samples=1025), "samples is 1025"), (dict(samples=2**32 + 1), "samples is"), (dict(eye=(0, 0)), "3 numbers"),
                              (dict(eye="far"), "eye is 'far'"), (dict(target=(0, "a", 0)), r"target\[1\] is 'a'"),
                              (dict(up=(math.nan, 0, 0)), r"up\[0\] is not finite"), (dict(eye=(9, 9, 9), azimuth=3), "azimuth is given"),
                              (dict(azimuth=361), "azimuth is 361"), (dict(field=0), "field is 0"), (dict(field=200), "field 200"),
                              (dict(color="mass"), "unknown quantity 'mass'"), (dict(color_range=(0, 1)), "color_range is of radius and speed"),
                              (dict(color="speed", color_range=(0, 0)), "must ascend"), (dict(color="speed", color_range=3), "2 numbers"),
                              (dict(out=np.zeros((60, 80, 3), np.uint8)), "out has shape"), (dict(out=np.zeros((60, 81, 4), np.uint8)), "height and width"),
                              (dict(out=np.zeros((60, 80, 4))), "out has shape"), (dict(out=read_only), "read-only"),
                              (dict(out=np.zeros((60, 80, 8), np.uint8)[..., ::2]), "strides"), (dict(out=[[0]]), "out is of type list")):
            with self.subTest(says), self.assertRaisesRegex(ValueError, says):
                if isinstance(options.get("out"), list):
                    options = {"width": None, "height": None, **options}
                moving.draw(**{"width": 80, "height": 60, **options})
        moving.draw(8, 6)

    def test_wrong_arguments(self):
        for options, says in ((dict(radii=[1.0]), r"radii has shape \(1,\)"), (dict(velocities=[[0, 0, 0]]), "velocities has 1 rows"),
                              (dict(gravity=math.nan), "gravity is not finite"), (dict(dt="fast"), "dt is 'fast'"),
                              (dict(contact="glue"), "unknown contact law 'glue'"), (dict(drag=1), "drag is given"),
                              (dict(plane=50), "below the plane"), (dict(walls=[[0, 0, 0]], contact="hertz"), "walls has 1 rows"),
                              (dict(restitution=0.5, contact="hertz"), "elastic"),
                              (dict(contact="hertz", pbc=True), "no box that repeats"), (dict(contact="hertz", pbc=(1, 0)), "three flags"),
                              (dict(contact="hertz", pbc=True, walls=((0, 0, 0), (6, 6, 6))), "gravity is")):
            with self.subTest(says), self.assertRaisesRegex(ValueError, says):
                spherepair.Simulation(**{**dict(positions=POSITIONS, radii=RADII, backend="cpu"), **options})
        with self.assertRaisesRegex(ValueError, "steps is -1"):
            simulation().move(-1)
        with self.assertRaises(ValueError):
            simulation(backend="abacus")

    def test_a_step_that_fails_is_the_last(self):
        falling = spherepair.Simulation([[0, 1, 0], [0.5, 1, 0]], [0.002, 0.001], contact="spring", stiffness=1e-4, dt=0.004,
                                        backend="cpu")
        with self.assertRaisesRegex(ValueError, "step 7 of 0.004 s: sphere 0"):
            falling.move(10)
        with self.assertRaisesRegex(ValueError, "a step of this simulation failed"):
            falling.positions

    def test_closed_ones_say_so(self):
        closed = simulation()
        closed.close()
        closed.close()
        for use in (lambda: closed.dt, closed.move, closed.pairs, closed.draw, closed.checkpoint, lambda: closed.save("x")):
            with self.assertRaisesRegex(spherepair.BackendError, "closed"):
                use()


if __name__ == "__main__":
    unittest.main()
