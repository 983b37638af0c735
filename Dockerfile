# mixcmp with all of its tools, on Debian 13:
#   docker build -t mixcmp .
#   docker run --rm -v "$PWD:/work" mixcmp check scene.toml
FROM debian:trixie-slim AS build
WORKDIR /mixcmp
COPY . .
RUN tests/package build/packages

FROM debian:trixie-slim
COPY --from=build /mixcmp/build/packages /tmp/packages
RUN apt-get update \
  && DEBIAN_FRONTEND=noninteractive apt-get install -y /tmp/packages/*.deb \
  && rm -rf /tmp/packages /var/lib/apt/lists/*
WORKDIR /work
ENTRYPOINT ["mixcmp"]
CMD ["--help"]
