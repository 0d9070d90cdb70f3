"""The report of a run as one HTML page; scripts/report_run.py assembles it."""
