"""Pictures by matplotlib."""

import io
import unittest

import matplotlib

matplotlib.use("Agg")

import passivity
from passivity import plot

SCENE = {"dimensionless": {"mu": 50, "beta": "3/5", "sigma": "3/5"}, "run": {"intervals": 500}}


class Pictures(unittest.TestCase):
    def test_motion(self):
        motion = passivity.simulate(SCENE, speed=5)
        axes = plot.motion(motion)
        self.assertEqual(len(axes.lines[0].get_xdata()), motion.intervals)
        axes.figure.savefig(io.BytesIO(), format="png")

    def test_outcomes(self):
        sweep = passivity.sweep(SCENE, beta="0:1:5", sigma="0:1:4", speed=[1, 5])
        for third in (0, 1):
            axes = plot.outcomes(sweep, third=third)
            image = axes.collections[0].get_array()
            self.assertEqual(image.shape, (4, 5))
            # The second value of σ at the last of β.
            place = (4 * 4 + 1) * 2 + third
            kinds = ["at_rest", "never_at_rest", "growing", "undecided"]
            self.assertEqual(kinds[int(image[1][4])], sweep.columns["exact"][place])
            axes.figure.savefig(io.BytesIO(), format="svg")


if __name__ == "__main__":
    unittest.main()
