"""tests/peers: what is made of the peers' times and pictures. Needs none of the peers."""
import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
try:
    import numpy
except ImportError:
    print("Skipped: numpy is not installed; ./dev setup installs it for Debian's own python3.")
    sys.exit(77)
import measures  # noqa: E402: found by the lines above
import table  # noqa: E402


class Peers(unittest.TestCase):
    def test_errors_of_blocks_take_what_is_left_at_the_borders(self):
        truth = numpy.zeros((9, 17), numpy.float32)
        picture = truth.copy()
        picture[8, 16] = 0.5  # a block of its own
        picture[0, 8:16] = 0.8  # an eighth of the second block
        blocks = measures.block_errors(picture, truth)
        self.assertEqual(blocks.shape, (2, 3))
        self.assertAlmostEqual(blocks[1, 2], 0.5)
        self.assertAlmostEqual(blocks[0, 1], 0.8 / 8 ** 0.5, places=6)
        self.assertEqual(numpy.count_nonzero(blocks), 2)
        self.assertAlmostEqual(measures.error(picture, truth)["block_max"], 0.5)
        self.assertAlmostEqual(measures.error(picture, truth)["rms"], ((0.25 + 8 * 0.64) / (9 * 17)) ** 0.5, places=6)

    def test_time_is_the_median_of_the_pairs(self):
        times = measures.times({"without": [10, 20, 10], "with": [15, 24, 100]})
        self.assertEqual(times["time_ms"], {"median": 5, "min": 4, "max": 90, "runs": 3})
        self.assertEqual(times["frame_ms"]["without"]["median"], 10)

    def test_reads_what_was_written(self):
        file = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory())) / "a.f32"
        values = numpy.arange(6, dtype=numpy.float32).reshape(2, 3)
        values.tofile(file)
        self.assertTrue((measures.read_values(file, 3, 2) == values).all())

    def test_table_leaves_out_what_is_not_known(self):
        summary = {"median": 12.34}
        lines = table.text_of([
            {"name": "peer", "time_ms": summary, "frame_ms": {"with": summary, "without": summary}, "gain": 2.0, "contrast": 0.05,
             "error_to_converged": {"rms": 0.1, "block_p99": 0.2, "block_max": 0.3}},
            {"name": "other", "time_ms": summary, "contrast": 0.06, "error_to_converged": {"rms": 0.1}},
        ]).splitlines()
        self.assertEqual(lines[1].split(), ["peer", "12.3", "12.3", "12.3", "2.00x", "0.0500", "0.1000", "0.2000", "0.3000"])
        self.assertEqual(lines[2].split(), ["other", "12.3", "0.0600", "0.1000"])


if __name__ == "__main__":
    unittest.main()
