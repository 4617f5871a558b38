"""docs/update_results.py: what it makes of reports, and whether it knows the blocks of docs/results.md."""
import json
import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "docs"))
import update_results  # noqa: E402: found by the line above


def result(camera, speedup, rms, efficiency=0.5):
    return {
        "scene": "hall", "camera": camera, "camera_name": "nave", "width": 64, "height": 36, "effect": "ssao",
        "samples": 4, "reference_time_ms": {"median": 20.0}, "time_ms": {"median": 10.0}, "speedup": speedup,
        "efficiency": efficiency, "work": 0.5, "error": {"rms": rms, "max": 0.5, "psnr": None, "ssim": 0.9}, "coverage": [0.25, 1.0], "stages_ms": {"edges": 5.0},
        "truth": {"ray_traced": {"rays": 256, "reference_rms": 0.1, "rms": 0.12}},
    }


def untimed_result():
    nothing = {"reference_time_ms": None, "time_ms": None, "speedup": None, "error": None, "truth": None, "stages_ms": {}}
    return result(2, None, None, None) | nothing


REPORT = {
    "commit": "abc", "date": "2026-01-02", "machine": {"renderer": "llvmpipe", "version": "4.5", "cores": 2},
    "results": [result(0, 2.0, 0.01), result(1, 3.0, 0.03), untimed_result()],
}


class UpdateResults(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        self.reports = self.folder / "reports"
        (self.reports / "made-up/plots").mkdir(parents=True)
        (self.reports / "made-up/plots/speedup-by-size.svg").write_text("<svg/>")
        (self.reports / "made-up/pareto.md").write_text("| technique |\n")

    def page(self, kind, report=REPORT):
        """The page after its one block was filled."""
        for folder in ("made-up", "made-up/ssao", "made-up/ssao-min-max-mips"):
            (self.reports / folder).mkdir(exist_ok=True)
            (self.reports / folder / "results.json").write_text(json.dumps(report))
        page = self.folder / "page.md"
        page.write_text(f"Before\n<!-- begin {kind} made-up -->\nold\n<!-- end -->\nAfter\n")
        update_results.update(self.reports, page)
        return page.read_text()

    def test_knows_every_block_of_the_page(self):
        blocks = update_results.BLOCK.findall(update_results.PAGE.read_text())
        self.assertGreater(len(blocks), 5)
        for _, kind, name, _ in blocks:
            self.assertIn(kind, update_results.KINDS, name)

    def test_replaces_blocks_and_nothing_else(self):
        for kind in update_results.KINDS:
            with self.subTest(kind):
                text = self.page(kind)
                self.assertTrue(text.startswith("Before\n") and text.endswith("<!-- end -->\nAfter\n"))
                self.assertNotIn("old", text)

    def test_does_without_results(self):
        for kind in update_results.KINDS:
            with self.subTest(kind):
                self.assertNotIn("old", self.page(kind, REPORT | {"results": []}))

    def test_takes_the_tables_of_rivals_as_they_are(self):
        self.assertIn("-->\n\n| technique |\n\n<!-- end", self.page("pareto"))
        (self.reports / "made-up/pareto.md").unlink()
        self.assertIn("old", self.page("pareto"))

    def test_names_machine_commit_and_date(self):
        self.assertIn("llvmpipe, 4.5, 2 cores, commit abc, 2026-01-02.\n", self.page("machine"))
        timed = REPORT | {"results": [r | {"seconds": 50.0} for r in REPORT["results"]]}
        self.assertIn("abc, 2026-01-02, 3 pictures in 2 minutes.\n", self.page("machine", timed))
        quick = REPORT | {"results": [r | {"seconds": 20.0} for r in REPORT["results"]]}
        self.assertIn("3 pictures in 1 minute.\n", self.page("machine", quick))

    def test_averages_what_is_there(self):
        self.assertIn("| ssao 4, 64×36 | 3 | 2.50 | 2.00 | 3.00 | 0.50 | 0.0200 | 0.0300 |", self.page("summary"))
        text = self.page("table")
        self.assertIn("| hall 2 (nave), 64×36, ssao 4 | – | – | – | – | – | – | – | – | 25 100 |", text)
        self.assertIn("| **mean** | **20** | **10** | **2.50** | **0.50** | **0.0200** | **0.500** | **–** | **0.9000** |  |", text)

    def test_has_a_row_for_each_variant(self):
        self.assertIn("| ssao | 3 | 2.50 | 0.500 | 0.0200 | 0.0300 |\n| ssao, min max mips | 3 |", self.page("variants"))

    def test_refuses_variants_of_several_commits(self):
        self.page("variants")
        report = self.reports / "made-up/ssao/results.json"
        report.write_text(json.dumps(REPORT | {"commit": "other"}))
        with self.assertRaisesRegex(SystemExit, "several commits"):
            update_results.update(self.reports, self.folder / "page.md")

    def test_tells_how_far_both_are_from_truth(self):
        self.assertIn("| ssao 4, 64×36 | ray traced, 256 rays | 2 | 0.1000 | 0.1200 | +20.0 % |", self.page("truth"))

    def test_keeps_old_plots_where_none_were_drawn(self):
        (self.reports / "made-up/plots/speedup-by-size.svg").unlink()
        self.assertIn("old", self.page("plots"))

    def test_keeps_the_plots_of_a_report_in_its_folder(self):
        stale = self.folder / "results/made-up/stale.svg"
        stale.parent.mkdir(parents=True)
        stale.write_text("")
        self.assertIn("![speedup by size](results/made-up/speedup-by-size.svg)", self.page("plots"))
        self.assertEqual([plot.name for plot in stale.parent.iterdir()], ["speedup-by-size.svg"])


if __name__ == "__main__":
    unittest.main()
