# SPDX-License-Identifier: MIT
"""Spheres that move: the program's own bits, closed forms, wrong arguments."""

import math
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

    def test_wrong_arguments(self):
        for options, says in ((dict(radii=[1.0]), r"radii has shape \(1,\)"), (dict(velocities=[[0, 0, 0]]), "velocities has 1 rows"),
                              (dict(gravity=math.nan), "gravity is not finite"), (dict(dt="fast"), "dt is 'fast'"),
                              (dict(contact="glue"), "unknown contact law 'glue'"), (dict(drag=1), "drag is given"),
                              (dict(plane=50), "below the plane"), (dict(walls=[[0, 0, 0]], contact="hertz"), "walls has 1 rows"),
                              (dict(restitution=0.5, contact="hertz"), "elastic")):
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
        for use in (lambda: closed.dt, closed.move, closed.pairs):
            with self.assertRaisesRegex(spherepair.BackendError, "closed"):
                use()


if __name__ == "__main__":
    unittest.main()
