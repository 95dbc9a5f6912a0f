"""`radartrack convert`: Parquet files of plots."""
